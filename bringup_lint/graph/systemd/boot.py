"""What waits for what at boot, and what brings it in: ways through the graph that hold on the robot.

The distribution's tables say what a package enables *if* it is installed; such edges do not count as a
reason here.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.dependencies import PULLING
from bringup_lint.graph.systemd.dependencies import expand_name
from bringup_lint.graph.systemd.dependencies import resolve
from bringup_lint.graph.systemd.unit import Unit

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.units import Units

ROOTS = ("default.target", "graphical.target", "multi-user.target")


def waits_for(units: Units, unit: Unit, name: str) -> list[Edge] | None:
    """The chain of ordering edges from the unit back to the one of that name: the unit starts after it."""
    graph = units.graph
    return _search(
        _nodes(units, unit),
        _named(units, unit, name),
        lambda node: (
            (edge, edge.source) for edge in graph.into.get(node, ()) if edge.kind == "orders" and _counts(units, edge)
        ),
    )


def ordered(units: Units, unit: Unit, name: str) -> bool:
    """Whether one of the two starts after the other, over any edge: both are taken to be there."""
    graph = units.graph
    nodes, goal = _nodes(units, unit), _named(units, unit, name)
    forward = _search(nodes, goal, lambda n: ((e, e.target) for e in graph.out.get(n, ()) if e.kind == "orders"))
    return bool(
        forward or _search(nodes, goal, lambda n: ((e, e.source) for e in graph.into.get(n, ()) if e.kind == "orders"))
    )


def brings_in(units: Units, unit: Unit, name: str) -> list[Edge] | None:
    """The chain of requirement edges from the unit to the one of that name: starting the unit starts it
    too."""
    return _search(_nodes(units, unit), _named(units, unit, name), lambda node: _pulled(units, node))


def brought_in(units: Units, near: Unit, name: str) -> list[Edge] | None:
    """The chain from a boot target, over lines of the tree, that starts the unit of that name at boot
    anyway."""
    kind = "unit" if near.manager == "system" else "user-unit"
    roots = {Node(kind, units.real_name(root, near.manager)) for root in ROOTS}
    return _search(roots, _named(units, near, name), lambda node: _pulled(units, node))


def _pulled(units: Units, node: Node) -> Iterator[tuple[Edge, Node]]:
    for edge in units.graph.out.get(node, ()):
        if edge.kind in PULLING and _counts(units, edge):
            yield edge, edge.target


def _counts(units: Units, edge: Edge) -> bool:
    """Whether the edge is there on every robot: not what a package that may not be installed would add."""
    return edge.where is not None or units.has_vendor_units or not edge.of_package


def _nodes(units: Units, unit: Unit) -> set[Node]:
    """The unit in the graph; all known instances of a template."""
    if not unit.is_template:
        return {units.node(unit)}
    place = units.node(unit).place
    prefix, suffix = unit.stem, "." + unit.type
    known = (*units.graph.out, *units.graph.into)
    return {
        node for node in known if node.place == place and node.name.startswith(prefix) and node.name.endswith(suffix)
    }


def _named(units: Units, near: Unit, name: str) -> Node | None:
    return resolve(expand_name(name, near.name) or name, near, units)


def _search(
    starts: set[Node], goal: Node | None, following: Callable[[Node], Iterator[tuple[Edge, Node]]]
) -> list[Edge] | None:
    arrived: dict[Node, tuple[Edge, Node]] = {}
    pending = deque(sorted(starts))
    while pending:
        node = pending.popleft()
        for edge, other in following(node):
            if other in arrived or other in starts:
                continue
            arrived[other] = (edge, node)
            if other == goal:
                way = []
                while other not in starts:
                    edge, other = arrived[other]
                    way.insert(0, edge)
                return way
            pending.append(other)
    return None
