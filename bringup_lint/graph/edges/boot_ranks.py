"""The boot order as numbers: how long the longest chain of ordering edges is that leads to a unit."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from bringup_lint.graph.edges.systemd import is_certain
from bringup_lint.graph.edges.systemd import naming
from bringup_lint.graph.graph import Node

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.units import Units


def boot_ranks(units: Units, nodes: Iterable[Node]) -> dict[Node, int]:
    """Numbers from 0 without gaps for these units; the members of an ordering cycle share one."""
    import networkx

    shown = naming(units)
    order: networkx.DiGraph[Node] = networkx.DiGraph()
    for edge in units.graph.edges("orders"):
        if is_certain(edge, units):
            order.add_edge(shown(edge.source), shown(edge.target))
    cycles = networkx.condensation(order)
    depth: dict[Node, int] = {}
    for generation, members in enumerate(networkx.topological_generations(cycles)):
        depth.update((node, generation) for member in members for node in cycles.nodes[member]["members"])
    known = {node: depth.get(node, 0) for node in nodes}
    rank = {value: at for at, value in enumerate(sorted(set(known.values())))}
    return {node: rank[value] for node, value in known.items()}
