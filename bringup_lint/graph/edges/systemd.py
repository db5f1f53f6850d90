"""Units as the tree names them: what its lines order and pull in, and who runs them.

The distribution's own units are left out unless a line of the tree names them.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING

from bringup_lint.graph.file_nodes import file_place
from bringup_lint.graph.file_nodes import is_plain
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.graph.graph import Origin
from bringup_lint.graph.systemd.references import instances
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values import split_name
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.units import Units

KINDS = ("unit", "user-unit")


class OwnUnit(NamedTuple):
    """A unit of the tree as the picture shows it: a template stands for all instances that no line names in full."""

    unit: Unit
    node: Node


def own_units(units: Units) -> list[OwnUnit]:
    """The units of the tree that can start."""
    shown = naming(units)
    return [
        OwnUnit(instance.unit, shown(instance.node))
        for instance in instances(units)
        if instance.unit.judged and instance.unit.files
    ]


def naming(units: Units) -> Callable[[Node], Node]:
    """Gives the template for an instance that only a specifier makes, such as ``alarm@%n.service``."""
    named = units.named_instances

    def shown(node: Node) -> Node:
        parts = split_name(node.name)
        manager = "system" if node.kind == "unit" else "user"
        template = f"{parts.prefix}@.{parts.type}"
        if not parts.instance or parts.instance in named.get((manager, template), ()):
            return node
        found = units.candidates(node.name, manager)
        return node._replace(name=template) if found and found[0].is_template else node

    return cache(shown)


def unit_edges(units: Units) -> list[Edge]:
    """What lines of the tree say, and what is known about the order of the units that they name."""
    shown = naming(units)
    edges = [edge._replace(source=shown(edge.source), target=shown(edge.target)) for edge in units.graph.edges()]
    named = {own.node for own in own_units(units)}
    named.update(node for edge in edges if _is_written(edge) for node in (edge.source, edge.target))
    joined = {frozenset((edge.source, edge.target)) for edge in edges if _is_written(edge)}
    kept = (edge for edge in edges if edge.source in named and edge.target in named and edge.source != edge.target)
    return list(dict.fromkeys(edge for edge in kept if _is_written(edge) or _is_shown(edge, joined, units)))


def _is_shown(edge: Edge, joined: set[frozenset[Node]], units: Units) -> bool:
    """Defaults are left out unless they tell the order of two units that a line joins."""
    if edge.origin is Origin.DEFAULT:
        return edge.kind == "orders" and frozenset((edge.source, edge.target)) in joined
    return is_certain(edge, units)


def is_certain(edge: Edge, units: Units) -> bool:
    """Whether the edge is there on every robot."""
    return edge.where is not None or units.has_vendor_units or not edge.of_package


def _is_written(edge: Edge) -> bool:
    return edge.where is not None and edge.where.source.judged


def unit_places(units: Units, nodes: set[Node]) -> Iterator[tuple[Node, Span]]:
    """The files of the units among the nodes, the unit's own first, then its drop-ins."""
    for own in own_units(units):
        yield from _files(own.node, own.unit)
    for node in sorted(node for node in nodes if node.kind in KINDS):
        found = units.candidates(node.name, "system" if node.kind == "unit" else "user")
        for unit in found if len(found) == 1 else [unit for unit in found if unit.place == node.place]:
            yield from _files(node, unit)


def _files(node: Node, unit: Unit) -> Iterator[tuple[Node, Span]]:
    for file in unit.files:
        yield node, file_place(file.source)


def user_edges(units: Units) -> Iterator[Edge]:
    """``runs-as``, where a unit says so."""
    for unit, node in own_units(units):
        user = unit.get("User")
        if user and is_plain(user):
            yield Edge("runs-as", node, Node("user", str(user)), user.span, "User=")
