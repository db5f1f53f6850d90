"""What waits for what at boot, and what brings it in: ways through the graph that hold on the robot.

The distribution's tables say what a package enables *if* it is installed; such edges do not count as a
reason here.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.named_units import NamedUnits
from bringup_lint.graph.systemd.references import expand_name
from bringup_lint.graph.systemd.references import resolve
from bringup_lint.graph.systemd.relations import PULLING
from bringup_lint.graph.systemd.unit import Unit

ROOTS = ("default.target", "graphical.target", "multi-user.target")

Steps = Iterable[tuple[Edge, Node]]
"""Edges that lead on from a node, each with its other end."""


@dataclass(eq=False)
class Boot:
    """What starts when, and why."""

    units: NamedUnits
    graph: Graph

    def waits_for(self, unit: Unit, name: str) -> list[Edge] | None:
        """The chain of ordering edges from the unit back to the one of that name: the unit starts after it."""
        return _search(self._nodes(unit), self._named(unit, name), self._earlier)

    def ordered(self, unit: Unit, name: str) -> bool:
        """Whether one of the two starts after the other, over any edge: both are taken to be there."""
        goal = self._named(unit, name)
        return goal is not None and _meet(self._nodes(unit), goal, self._orders, self._ordered_by)

    def brings_in(self, unit: Unit, name: str) -> list[Edge] | None:
        """The chain of requirement edges from the unit to the one of that name: starting the unit starts it
        too."""
        return _search(self._nodes(unit), self._named(unit, name), self._pulled)

    def brought_in(self, near: Unit, name: str) -> list[Edge] | None:
        """The chain from a boot target, over lines of the tree, that starts the unit of that name at boot
        anyway."""
        kind = "unit" if near.manager == "system" else "user-unit"
        roots = {Node(kind, self.units.real_name(root, near.manager)) for root in ROOTS}
        return _search(roots, self._named(near, name), self._pulled)

    def _orders(self, node: Node) -> Iterator[Node]:
        return (edge.target for edge in self.graph.out.get(node, ()) if edge.kind == "orders")

    def _ordered_by(self, node: Node) -> Iterator[Node]:
        return (edge.source for edge in self.graph.into.get(node, ()) if edge.kind == "orders")

    def _earlier(self, node: Node) -> Steps:
        for edge in self.graph.into.get(node, ()):
            if edge.kind == "orders" and self._counts(edge):
                yield edge, edge.source

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
        prefix, suffix = unit.stem, "." + unit.type
        known = (*self.graph.out, *self.graph.into)
        return {
            node
            for node in known
            if node.place == place and node.name.startswith(prefix) and node.name.endswith(suffix)
        }

    def _named(self, near: Unit, name: str) -> Node | None:
        return resolve(expand_name(name, near.name) or name, near, self.units)


def _search(starts: set[Node], goal: Node | None, following: Callable[[Node], Steps]) -> list[Edge] | None:
    """The shortest way from one of the starts to the goal; None when there is none."""
    if goal is None:
        return None
    arrived: dict[Node, tuple[Edge, Node]] = {}
    pending = deque(sorted(starts))
    while pending:
        node = pending.popleft()
        for edge, other in following(node):
            if other in arrived or other in starts:
                continue
            arrived[other] = (edge, node)
            if other == goal:
                return _way(arrived, goal, starts)
            pending.append(other)
    return None


def _way(arrived: dict[Node, tuple[Edge, Node]], goal: Node, starts: set[Node]) -> list[Edge]:
    way = []
    node = goal
    while node not in starts:
        edge, node = arrived[node]
        way.append(edge)
    return way[::-1]


def _meet(starts: set[Node], goal: Node, *directions: Callable[[Node], Iterable[Node]]) -> bool:
    """Whether the goal can be reached in one of the directions. They take turns, so that a goal that is near in one
    is found before the other is searched to its end."""
    searches = [(following, deque(sorted(starts)), set(starts)) for following in directions]
    while any(pending for _, pending, _ in searches):
        for following, pending, seen in searches:
            fresh = set(following(pending.popleft())) - seen if pending else set()
            if goal in fresh:
                return True
            seen |= fresh
            pending.extend(fresh)
    return False
