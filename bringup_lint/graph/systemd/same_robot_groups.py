"""Units that surely run on the same robot: of one root file system or overlay, else those that name each other."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.systemd.named_units import NamedUnits
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.variants import overlay_of

_NAMING = (
    *("Requires", "Requisite", "Wants", "BindsTo", "PartOf", "Upholds", "After", "Before", "Conflicts"),
    *("OnFailure", "OnSuccess", "PropagatesStopTo", "StopPropagatedFrom", "JoinsNamespaceOf"),
)
_INSTALLING = ("WantedBy", "RequiredBy", "UpheldBy", "Also")


def same_robot_groups(units: NamedUnits, chosen: Iterable[Unit]) -> list[list[Unit]]:
    """The chosen units in groups. In a plain folder of a repository only names join them: units of several robots may
    lie side by side there."""
    chosen = list(chosen)
    groups: dict[str | Unit, list[Unit]] = {}
    leaders = _leaders(units) if any(_overlay(unit) is None for unit in chosen) else {}
    for unit in chosen:
        overlay = _overlay(unit)
        key = overlay if overlay is not None else leaders.get(unit, unit)
        groups.setdefault(key, []).append(unit)
    return list(groups.values())


def _overlay(unit: Unit) -> str | None:
    return overlay_of(unit.files[0].source) if unit.files else None


def _leaders(units: NamedUnits) -> dict[Unit, Unit]:
    """For every unit one that stands for all that are joined to it by names, directly or through others."""
    parents = {unit: unit for unit in units.all}

    def leader(unit: Unit) -> Unit:
        while parents[unit] is not unit:
            parents[unit] = parents[parents[unit]]
            unit = parents[unit]
        return unit

    for unit in units.all:
        for name in _named(unit):
            other = units.find(name, unit)
            if other is not None and units.files.same_robot(unit.where.source, other.where.source):
                parents[leader(unit)] = leader(other)
    return {unit: leader(unit) for unit in parents}


def _named(unit: Unit) -> Iterator[str]:
    for key in _NAMING:
        yield from unit.words(key)
    for key in _INSTALLING:
        yield from unit.words(key, "Install")
