"""Requirement and ordering edges between units, as units write them; the implicit ones and the
distribution's are added."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.distribution import distribution_edges
from bringup_lint.graph.systemd.implicit import after_members
from bringup_lint.graph.systemd.implicit import implicit_edges
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.parsers.systemd_values import expand
from bringup_lint.parsers.systemd_values import split_name
from bringup_lint.parsers.systemd_values import unit_specifiers
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.named_units import Link
    from bringup_lint.graph.systemd.units import Units

PULLS = {
    "Requires": "requires",
    "Requisite": "requisite",
    "BindsTo": "binds-to",
    "Wants": "wants",
    "Upholds": "upholds",
}
HARD = frozenset({"requires", "binds-to"})
PULLING = frozenset({"requires", "binds-to", "wants", "upholds"})
"""Edges that bring the target into the transaction of the source."""
ORDERS = frozenset({"orders"})
INSTALLED = {"WantedBy": "wants", "RequiredBy": "requires", "UpheldBy": "upholds"}
_OTHER = {"PartOf": "part-of", "Conflicts": "conflicts", "OnFailure": "on-failure", "OnSuccess": "on-success"}
_DEFAULT_INSTANCE = "i"


class Instance(NamedTuple):
    """A unit as it takes part in a transaction: itself, or a template with one instance."""

    unit: Unit
    name: str
    node: Node


def resolve(name: str, near: Unit, units: Units) -> Node | None:
    """The node that a unit name means in a unit; None when it is masked, another robot's, or
    could mean several units."""
    found = units.find(name, near)
    if found is None:
        if units.candidates(name, near.manager):
            return None
        return Node(_kind(near.manager), units.real_name(name, near.manager))
    if found.masked:
        return None
    instance = split_name(name).instance
    return units.node(found, instance) if found.is_template and instance else units.node(found)


def _kind(manager: str) -> str:
    return "unit" if manager == "system" else "user-unit"


def expand_name(name: str, unit_name: str) -> str | None:
    """A unit name with the specifiers that follow from the unit's own name; None for others
    (systemd.unit(5)). A template
    without an instance gets the name of the unit as its instance."""
    parts = split_name(name)
    if parts.is_template:
        own = split_name(unit_name)
        name = f"{parts.prefix}@{own.instance or own.prefix}.{parts.type}"
    return expand(name, unit_specifiers(unit_name)) if "%" in name else name


def dependency_graph(units: Units) -> Graph:
    """All edges between units that the tree or the distribution states."""
    graph = Graph()
    for instance in instances(units):
        graph.add(_written(instance, units))
        if instance.unit.fragment is not None:
            graph.add(implicit_edges(instance, units))
    for link in units.links:
        graph.add(_linked(link, units))
    if not units.has_vendor_units:
        graph.add(distribution_edges(units))
    graph.add(list(after_members(graph, units)))
    return graph


def instances(units: Units) -> Iterator[Instance]:
    """Every unit that can start; a template once for each instance that the tree names, or once for a
    made-up one."""
    named = named_instances(units)
    for unit in units.all:
        if unit.masked:
            continue
        if not unit.is_template:
            yield Instance(unit, unit.name, units.node(unit))
            continue
        for word in sorted(named.get((unit.manager, unit.name), {_DEFAULT_INSTANCE})):
            yield Instance(unit, f"{unit.stem}{word}.{unit.type}", units.node(unit, word))


def named_instances(units: Units) -> dict[tuple[str, str], set[str]]:
    """(manager, template) -> the instances that something in the tree names."""
    found: dict[tuple[str, str], set[str]] = {}
    named = [
        (unit.manager, word) for unit in units.all for key in (*PULLS, "After", "Before") for word in unit.words(key)
    ]
    for manager, word in [*named, *((link.manager, link.name) for link in units.links)]:
        parts = split_name(word)
        if parts.instance and "%" not in parts.instance:
            found.setdefault((manager, f"{parts.prefix}@.{parts.type}"), set()).add(parts.instance)
    return found


def targets(instance: Instance, units: Units, words: Iterable[Located]) -> Iterator[tuple[Node, Span]]:
    """The nodes that the words of a setting name, each with its place."""
    for word in words:
        name = expand_name(word, instance.name)
        node = resolve(name, instance.unit, units) if name else None
        if node is not None and node != instance.node:
            yield node, word.span


def _written(instance: Instance, units: Units) -> Iterator[Edge]:
    unit, here = instance.unit, instance.node
    for key, kind in (PULLS | _OTHER).items():
        for there, span in targets(instance, units, unit.words(key)):
            yield Edge(kind, here, there, span, f"{key}=")
    for there, span in targets(instance, units, unit.words("After")):
        yield Edge("orders", there, here, span, "After=")
    for there, span in targets(instance, units, unit.words("Before")):
        yield Edge("orders", here, there, span, "Before=")
    if not units.installs(unit):
        return
    for key, kind in INSTALLED.items():
        for there, span in targets(instance, units, unit.words(key, "Install")):
            yield Edge(kind, there, here, span, f"{key}=")


def _linked(link: Link, units: Units) -> Iterator[Edge]:
    near = Unit(link.unit, link.manager, place=link.place)
    here, there = resolve(link.unit, near, units), resolve(link.name, near, units)
    if here and there:
        kind = PULLS[link.relation]
        where = link.source.whole if link.source.judged else None
        yield Edge(kind, here, there, where, f".{kind} link")
