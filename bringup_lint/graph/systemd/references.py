"""What unit names mean: in a setting of a unit, for a template and its instances, as nodes of the graph."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.named_units import NamedUnits
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values import expand
from bringup_lint.parsers.systemd_values import split_name
from bringup_lint.parsers.systemd_values import unit_specifiers
from bringup_lint.source import Located
from bringup_lint.source import Span

_DEFAULT_INSTANCE = "i"


class Instance(NamedTuple):
    """A unit as it takes part in a transaction: itself, or a template with one instance."""

    unit: Unit
    name: str
    node: Node


def resolve(name: str, near: Unit, units: NamedUnits) -> Node | None:
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


def instances(units: NamedUnits) -> Iterator[Instance]:
    """Every unit that can start; a template once for each instance that the tree names, or once for a
    made-up one."""
    named = units.named_instances
    for unit in units.all:
        if unit.masked:
            continue
        if not unit.is_template:
            yield Instance(unit, unit.name, units.node(unit))
            continue
        for word in sorted(named.get((unit.manager, unit.name), {_DEFAULT_INSTANCE})):
            yield Instance(unit, f"{unit.stem}{word}.{unit.type}", units.node(unit, word))


def targets(instance: Instance, units: NamedUnits, words: Iterable[Located]) -> Iterator[tuple[Node, Span]]:
    """The nodes that the words of a setting name, each with its place."""
    for word in words:
        name = expand_name(word, instance.name)
        node = resolve(name, instance.unit, units) if name else None
        if node is not None and node != instance.node:
            yield node, word.span
