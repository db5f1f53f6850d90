"""Requirement and ordering edges between units: written ones, implicit ones, and the distribution's own.

systemd.unit(5), "Implicit Dependencies" and "Default Dependencies" there and in the man page of each unit type.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.unit import Unit
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.units import Units

PULLS = {"Requires": "requires", "Requisite": "requisite", "BindsTo": "binds-to", "Wants": "wants", "Upholds": "upholds"}
HARD = frozenset({"requires", "binds-to"})
PULLING = frozenset({"requires", "binds-to", "wants", "upholds"})
_OTHER = {"PartOf": "part-of", "Conflicts": "conflicts", "OnFailure": "on-failure", "OnSuccess": "on-success"}
_INSTALLED = {"WantedBy": "wants", "RequiredBy": "requires", "UpheldBy": "upholds"}
_GROUPING_TARGET = {"socket": "sockets.target", "timer": "timers.target", "path": "paths.target"}
_TRIGGERS = {"timer": "Timer", "path": "Path", "socket": "Socket"}
_FALSE = frozenset({"no", "false", "0", "off", "n", "f"})


def unit_node(name: str) -> Node:
    return Node("unit", name)


def expand_name(name: str, unit: Unit, instance: str) -> str | None:
    """A unit name with the specifiers that the unit itself decides (%i, %I, %j, %J, %n, %N, %p, %P); None for others."""
    if name.rpartition(".")[0].endswith("@"):
        stem, _, suffix = name.rpartition(".")
        name = f"{stem}{instance or unit.stem}.{suffix}"
    if "%" not in name:
        return name
    prefix = unit.stem.partition("@")[0]
    full = f"{prefix}@{instance}" if instance else unit.stem
    values = {"i": instance, "I": instance, "p": prefix, "P": prefix, "n": f"{full}.{unit.type}", "N": full, "%": "%"}
    values |= {"j": prefix.rpartition("-")[2], "J": prefix.rpartition("-")[2]}
    parts = name.split("%")
    out = parts[0]
    at = 1
    while at < len(parts):
        head = parts[at][:1]
        if head == "" and at + 1 < len(parts):
            out += "%" + parts[at + 1]
            at += 2
            continue
        if head not in values:
            return None
        out += values[head] + parts[at][1:]
        at += 1
    return out


def dependency_graph(units: Units) -> Graph:
    """All edges between units that the tree or the distribution states."""
    graph = Graph()
    instances = _instances(units)
    for unit in units.all:
        if unit.masked:
            continue
        for instance in instances.get(unit.name, {"i"}) if unit.is_template else {unit.instance}:
            graph.add(_written(unit, instance, units))
            if unit.fragment is not None:
                graph.add(_implicit(unit, instance, units))
    for link in units.links:
        kind = {"Wants": "wants", "Requires": "requires", "Upholds": "upholds"}[link.relation]
        graph.add([Edge(kind, unit_node(link.unit), unit_node(str(link.name)), link.source.whole, f".{kind} link")])
    graph.add(_of_distribution(units))
    graph.add(list(_after_members(graph, units)))
    return graph


def _instances(units: Units) -> dict[str, set[str]]:
    """Template -> the instances that something in the tree names."""
    found: dict[str, set[str]] = {}
    words = [word for unit in units.all for key in (*PULLS, "After", "Before") for word in unit.words(key)]
    for word in [*words, *(link.name for link in units.links)]:
        stem, _, suffix = word.rpartition(".")
        prefix, at, instance = stem.partition("@")
        if at and instance and "%" not in instance:
            found.setdefault(f"{prefix}@.{suffix}", set()).add(instance)
    return found


def _name(unit: Unit, instance: str) -> str:
    return f"{unit.stem}{instance}.{unit.type}" if unit.is_template else unit.name


def _targets(unit: Unit, instance: str, units: Units, words: list[Located]) -> Iterator[tuple[Node, Span]]:
    for word in words:
        name = expand_name(word, unit, instance)
        if name is None:
            continue
        found = units.find(name, unit)
        if found is None and len(units.candidates(name, unit.manager)) > 1:
            continue
        alias = found is not None and name in found.aliases
        yield unit_node(found.name if alias else name), word.span


def _written(unit: Unit, instance: str, units: Units) -> Iterator[Edge]:
    here = unit_node(_name(unit, instance))
    for key, kind in (PULLS | _OTHER).items():
        for there, span in _targets(unit, instance, units, unit.words(key)):
            yield Edge(kind, here, there, span, f"{key}=")
    for there, span in _targets(unit, instance, units, unit.words("After")):
        if there != here:
            yield Edge("orders", there, here, span, "After=")
    for there, span in _targets(unit, instance, units, unit.words("Before")):
        if there != here:
            yield Edge("orders", here, there, span, "Before=")
    for key, kind in _INSTALLED.items():
        for there, span in _targets(unit, instance, units, unit.words(key, "Install")):
            yield Edge(kind, there, here, span, f"{key}=")


def has_default_dependencies(unit: Unit) -> bool:
    value = unit.get("DefaultDependencies", "Unit")
    return value is None or value.lower() not in _FALSE


def _implicit(unit: Unit, instance: str, units: Units) -> Iterator[Edge]:
    here = unit_node(_name(unit, instance))
    yield from _default_edges(here.name, has_default_dependencies(unit))
    if unit.type in _TRIGGERS:
        yield from _trigger(unit, instance, units, here)
    slice_name = unit.get("Slice")
    if slice_name and "%" not in slice_name:
        yield Edge("requires", here, unit_node(slice_name), slice_name.span, "Slice=")
        yield Edge("orders", unit_node(slice_name), here, slice_name.span, "Slice=")
    for word in unit.words("Sockets", "Service"):
        yield Edge("orders", unit_node(str(word)), here, word.span, "Sockets=")
    if unit.type == "service" and unit.get("Type") == "dbus":
        reason = "implicit: Type=dbus"
        yield Edge("requires", here, unit_node("dbus.socket"), None, reason)
        yield Edge("orders", unit_node("dbus.socket"), here, None, reason)


def _trigger(unit: Unit, instance: str, units: Units, here: Node) -> Iterator[Edge]:
    """The unit that a timer, path or socket starts, which is ordered after it."""
    key = "Service" if unit.type == "socket" else "Unit"
    named = unit.get(key, _TRIGGERS[unit.type])
    if named:
        ends = list(_targets(unit, instance, units, [named]))
    else:
        ends = [(unit_node(f"{here.name.rpartition('.')[0]}.service"), unit.where)]
    for there, span in ends:
        why = f"{key}=" if named else f"implicit: a {unit.type} is ordered before the service it starts"
        yield Edge("triggers", here, there, span, why)
        yield Edge("orders", here, there, span if named else None, why)


def _default_edges(name: str, enabled: bool) -> Iterator[Edge]:
    """DefaultDependencies=yes: what every unit of the type has."""
    if not enabled:
        return
    kind = name.rpartition(".")[2]
    here = unit_node(name)
    reason = f"implicit: default dependency of a {kind}"
    if kind in ("service", "socket", "timer", "path"):
        yield Edge("requires", here, unit_node("sysinit.target"), None, reason)
        yield Edge("orders", unit_node("sysinit.target"), here, None, reason)
    if kind == "service":
        yield Edge("orders", unit_node("basic.target"), here, None, reason)
    if kind in _GROUPING_TARGET:
        yield Edge("orders", here, unit_node(_GROUPING_TARGET[kind]), None, reason)


def _of_distribution(units: Units) -> Iterator[Edge]:
    """What the distribution's units state, except those that the tree brings itself."""
    from bringup_lint.facts import table

    version = min((249, 252, 255), key=lambda known: abs(known - units.robot.target.systemd))
    own = {name for unit in units.all if unit.fragment or unit.masked for name in (unit.name, *unit.aliases)}
    defaults = {}
    for row in table("systemd_units"):
        if _ships(row, version) and not row["alias_of"]:
            defaults[row["unit"]] = row["default_dependencies"] == "yes"
    aliases = {row["unit"]: row["alias_of"] for row in table("systemd_units") if row["alias_of"] not in ("", "masked")}
    for row in table("systemd_unit_edges"):
        name, relation, other = row["unit"], row["relation"], row["target"]
        if name not in defaults or name in own or not _ships(row, version):
            continue
        other = aliases.get(other, other)
        here, there = unit_node(name), unit_node(other)
        why = f"{relation}= of the distribution's {name}"
        if relation == "After":
            yield Edge("orders", there, here, None, why)
        elif relation == "Before":
            yield Edge("orders", here, there, None, why)
        elif relation in PULLS:
            yield Edge(PULLS[relation], here, there, None, why)
        elif relation in _INSTALLED:
            yield Edge(_INSTALLED[relation], there, here, None, why)
    for name, enabled in defaults.items():
        if name not in own:
            yield from _default_edges(name, enabled)


def _ships(row: dict[str, str], version: int) -> bool:
    return row["releases"] == "*" or str(version) in row["releases"].split(",")


def _after_members(graph: Graph, units: Units) -> Iterator[Edge]:
    """A target is ordered after what it wants or requires, unless one side says otherwise (systemd.target(5))."""
    without = {unit.name for unit in units.all if unit.fragment and not has_default_dependencies(unit)}
    from bringup_lint.facts import table

    own = {unit.name for unit in units.all}
    without |= {
        row["unit"] for row in table("systemd_units") if row["default_dependencies"] == "no" and row["unit"] not in own
    }
    for target, edges in graph.out.items():
        if not target.name.endswith(".target") or target.name in without:
            continue
        ordered = {edge.target for edge in edges if edge.kind == "orders"}
        ordered |= {edge.source for edge in graph.into.get(target, ()) if edge.kind == "orders"}
        for edge in edges:
            if edge.kind in ("wants", "requires") and edge.target not in ordered and edge.target.name not in without:
                why = f"implicit: {target.name} is ordered after what it pulls in"
                yield Edge("orders", edge.target, target, edge.where, f"{why} ({edge.why})" if edge.where else why)
                ordered.add(edge.target)
