"""Whether all orders that a tree states go forward in the boot of the distribution, so that none can close a cycle. The
few orders of the tree tell this with a table of the order in which the distribution's units start
(``systemd/boot_order``), without the hundreds of orders that these state."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise

from bringup_lint.facts import rows
from bringup_lint.graph.components import in_order
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd import shipped_units
from bringup_lint.graph.systemd.implicit import MEMBERS
from bringup_lint.graph.systemd.named_units import NamedUnits


def all_go_forward(stated: Graph, units: NamedUnits) -> bool:
    """False where that is not known. ``stated``: the edges of the tree."""
    if units.has_vendor_units or _changes_shipped_units(units):
        return False
    later: dict[Node, set[Node]] = {}
    for edge in stated.edges():
        for before, after in _orders(edge):
            later.setdefault(before, set()).add(after)
            later.setdefault(after, set())
    for one, other in pairwise(sorted((_step(node), node) for node in later if _step(node))):
        later[one[1]].add(other[1])
        if one[0] == other[0]:
            later[other[1]].add(one[1])
    return all(len(component) == 1 for component in in_order(later, later.__getitem__))


def _changes_shipped_units(units: NamedUnits) -> bool:
    """Whether the tree has a unit or a drop-in for one of the distribution, whose orders are others then."""
    shipped = shipped_units.names()
    return any(not shipped.isdisjoint((unit.name, *unit.aliases)) for unit in units.all)


def _orders(edge: Edge) -> Iterator[tuple[Node, Node]]:
    """What an edge may order, the first before the second: a target starts after what it pulls in."""
    if edge.kind == "orders":
        yield edge.source, edge.target
    elif edge.kind in MEMBERS and edge.source.name.endswith(".target"):
        yield edge.target, edge.source


def _step(node: Node) -> int:
    """When a unit of the distribution starts, from 1; 0 for others."""
    return _steps().get(node.name, 0) if node.kind == "unit" and not node.place else 0


@lru_cache
def _steps() -> dict[str, int]:
    return {unit: int(step) for unit, step in rows("systemd/boot_order")[1]}
