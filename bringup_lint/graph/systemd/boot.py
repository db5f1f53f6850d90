"""What waits for what at boot, and what brings it in: ways through the graph that hold on the robot.

The distribution's tables say what a package enables *if* it is installed; such edges do not count as a
reason here.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.memo import memo
from bringup_lint.graph.systemd.named_units import NamedUnits
from bringup_lint.graph.systemd.reachability import Reachability
from bringup_lint.graph.systemd.references import expand_name
from bringup_lint.graph.systemd.references import resolve
from bringup_lint.graph.systemd.relations import PULLING
from bringup_lint.graph.systemd.relations import ROOTS
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.named_tuple import NamedTuple

Steps = Iterable[tuple[Edge, Node]]
"""Edges that lead on from a node, each with its other end."""


@dataclass(eq=False)
class Boot:
    """What starts when, and why."""

    units: NamedUnits
    stated: Graph
    """What the tree states, which answers most questions: units name what they wait for and need."""
    whole: Callable[[], Graph]
    """Gives the graph with the distribution's edges."""
    _last: dict[Node, dict[Node, _Last]] = field(default_factory=dict)
    _at_boot: dict[str, set[Node]] = field(default_factory=dict)

    @cached_property
    def graph(self) -> Graph:
        return self.whole()

    def waits_for(self, unit: Unit, name: str) -> Edge | None:
        """The edge at the end of the shortest chain of ordering from the unit back to the one of that name: the unit
        starts after it."""
        goal = self._named(unit, name)
        if goal is None:
            return None
        stated = (edge for edge in self._between(unit, goal) if edge.kind == "orders" and edge.source == goal)
        return next(stated, None) or self._in_the_end(unit, goal)

    def _in_the_end(self, unit: Unit, goal: Node) -> Edge | None:
        starts = self._nodes(unit)
        if goal in starts:
            return None
        if goal not in self._last:
            self._last[goal] = _last_edges(goal, self._later, self._earlier)
        last = self._last[goal]
        near = min((node for node in sorted(starts) if node in last), key=lambda node: last[node].steps, default=None)
        return None if near is None else last[near].edge

    def ordered(self, unit: Unit, name: str) -> bool:
        """Whether one of the two starts after the other, over any edge: both are taken to be there."""
        goal = self._named(unit, name)
        if goal is None:
            return False
        if any(edge.kind == "orders" for edge in self._between(unit, goal)):
            return True
        starts = self._nodes(unit)
        if goal in starts:
            return False
        return self._order.leads(starts, goal) or any(self._order.leads({goal}, start) for start in starts)

    def brings_in(self, unit: Unit, name: str) -> bool:
        """Whether starting the unit starts the one of that name too."""
        goal = self._named(unit, name)
        if goal is None:
            return False
        if any(edge.kind in PULLING and edge.target == goal for edge in self._between(unit, goal)):
            return True
        return self._requirements.leads(self._nodes(unit), goal)

    def _between(self, unit: Unit, other: Node) -> Iterator[Edge]:
        """What the tree states of a unit and another one; nothing of templates, for which their instances stand."""
        here = self.units.node(unit)
        if unit.is_template or here == other:
            return
        yield from self._stated_of(here).get(other, ())

    @memo
    def _stated_of(self, here: Node) -> dict[Node, list[Edge]]:
        """Another unit -> what the tree states of it and of this one."""
        found: dict[Node, list[Edge]] = {}
        for ends in (self.stated.into, self.stated.out):
            for edge in ends.get(here, ()):
                found.setdefault(edge.target if edge.source == here else edge.source, []).append(edge)
        return found

    def brought_in(self, near: Unit, name: str) -> bool:
        """Whether a boot target, over lines of the tree, starts the unit of that name at boot anyway."""
        kind = "unit" if near.manager == "system" else "user-unit"
        return self._named(near, name) in self._started(kind, near.manager)

    @property
    def components(self) -> list[set[Node]]:
        """The sets of units that all wait for each other."""
        return self._order.components

    @cached_property
    def _order(self) -> Reachability:
        return Reachability(
            self._known,
            lambda node: (edge.target for edge in self.graph.out.get(node, ()) if edge.kind == "orders"),
        )

    @cached_property
    def _requirements(self) -> Reachability:
        return Reachability(self._known, lambda node: (other for _, other in self._pulled(node)))

    @cached_property
    def _known(self) -> list[Node]:
        return list(dict.fromkeys((*self.graph.out, *self.graph.into)))

    def _started(self, kind: str, manager: str) -> set[Node]:
        """What the boot targets of a manager start, without themselves."""
        if kind not in self._at_boot:
            roots = {Node(kind, self.units.real_name(root, manager)) for root in ROOTS}
            self._at_boot[kind] = set(_reached(roots, self._pulled))
        return self._at_boot[kind]

    def _earlier(self, node: Node) -> Steps:
        for edge in self.graph.into.get(node, ()):
            if edge.kind == "orders" and self._counts(edge):
                yield edge, edge.source

    def _later(self, node: Node) -> Steps:
        for edge in self.graph.out.get(node, ()):
            if edge.kind == "orders" and self._counts(edge):
                yield edge, edge.target

    def _pulled(self, node: Node) -> Steps:
        for edge in self.graph.out.get(node, ()):
            if edge.kind in PULLING and self._counts(edge):
                yield edge, edge.target

    def _counts(self, edge: Edge) -> bool:
        """Whether the edge is there on every robot: not what a package that may not be installed would add."""
        return edge.where is not None or self.units.has_vendor_units or not edge.of_package

    def _nodes(self, unit: Unit) -> set[Node]:
        """The unit in the graph; all known instances of a template."""
        if not unit.is_template:
            return {self.units.node(unit)}
        place = self.units.node(unit).place
        return self._instances.get((place, unit.name.partition("@")[0], unit.type), set())

    @cached_property
    def _instances(self) -> dict[tuple[str, str, str], set[Node]]:
        """Place, template and type -> the nodes of the graph that are instances of it, or the template itself."""
        found: dict[tuple[str, str, str], set[Node]] = {}
        for node in self._known:
            prefix, at, _ = node.name.partition("@")
            if at:
                found.setdefault((node.place, prefix, node.name.rpartition(".")[2]), set()).add(node)
        return found

    def _named(self, near: Unit, name: str) -> Node | None:
        return resolve(expand_name(name, near.name) or name, near, self.units)


class _Last(NamedTuple):
    """The end of the shortest way from a node to a goal."""

    steps: int
    edge: Edge


def _last_edges(goal: Node, backward: Callable[[Node], Steps], forward: Callable[[Node], Steps]) -> dict[Node, _Last]:
    """The last edge of the shortest way to the goal, for each node that has one; of several the way whose first edges
    come first."""
    steps = {goal: 0}
    for _, node, other in _reached_over({goal}, backward):
        steps[other] = steps[node] + 1
    found: dict[Node, _Last] = {}
    for node in steps:
        if node != goal:
            edge, nearer = next((edge, other) for edge, other in forward(node) if steps.get(other) == steps[node] - 1)
            found[node] = _Last(steps[node], edge if nearer == goal else found[nearer].edge)
    return found


def _reached(starts: set[Node], following: Callable[[Node], Steps]) -> Iterator[Node]:
    return (other for _, _, other in _reached_over(starts, following))


def _reached_over(starts: set[Node], following: Callable[[Node], Steps]) -> Iterator[tuple[Edge, Node, Node]]:
    """Each node that the starts lead to, the nearest first, with the edge and the node that it was reached over."""
    seen = set(starts)
    pending = deque(sorted(starts))
    while pending:
        node = pending.popleft()
        for edge, other in following(node):
            if other not in seen:
                seen.add(other)
                pending.append(other)
                yield edge, node, other
