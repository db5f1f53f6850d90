"""Units that surely run on the same robot: of one root file system or overlay, else those that name each other, in
their settings or in what they run, and those that one script enables."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from itertools import chain

from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.systemd.named_units import NamedUnits
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.variants import overlay_of
from bringup_lint.parsers.shell import shell_commands
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.process import Process
    from bringup_lint.source import Located

_NAMING = (
    *("Requires", "Requisite", "Wants", "BindsTo", "PartOf", "Upholds", "After", "Before", "Conflicts"),
    *("OnFailure", "OnSuccess", "PropagatesStopTo", "StopPropagatedFrom", "JoinsNamespaceOf"),
)
_INSTALLING = ("WantedBy", "RequiredBy", "UpheldBy", "Also")
_VERBS = frozenset(("enable", "reenable", "start", "restart", "try-restart", "is-active"))
"""What is stopped may be another robot, or a simulation that never runs beside it."""


def same_robot_groups(
    units: NamedUnits, chosen: Iterable[Unit], processes: Callable[[Unit], list[Process]]
) -> list[list[Unit]]:
    """The chosen units in groups. In a plain folder of a repository only names join them: units of several robots may
    lie side by side there."""
    chosen = list(chosen)
    groups: dict[str | Unit, list[Unit]] = {}
    plain = [unit for unit in chosen if _overlay(unit) is None]
    leaders = _leaders(units, plain, processes) if len(plain) > 1 else {}
    for unit in chosen:
        overlay = _overlay(unit)
        key = overlay if overlay is not None else leaders.get(unit, unit)
        groups.setdefault(key, []).append(unit)
    return list(groups.values())


def _overlay(unit: Unit) -> str | None:
    return overlay_of(unit.files[0].source) if unit.files else None


def _leaders(units: NamedUnits, plain: list[Unit], processes: Callable[[Unit], list[Process]]) -> dict[Unit, Unit]:
    """For every unit one that stands for all that are joined to it by names, directly or through others."""
    parents = {unit: unit for unit in units.all}

    def leader(unit: Unit) -> Unit:
        while parents[unit] is not unit:
            parents[unit] = parents[parents[unit]]
            unit = parents[unit]
        return unit

    by_settings = ((unit, name) for unit in units.all for name in _named(unit))
    by_commands = ((unit, name) for unit in plain for name in _commanded(processes(unit)))
    for unit, name in chain(by_settings, by_commands):
        other = units.find(name, unit)
        if other is not None and units.files.same_robot(unit.where.source, other.where.source):
            parents[leader(unit)] = leader(other)
    for first, *others in _enabled_together(units):
        for other in others:
            parents[leader(other)] = leader(first)
    return {unit: leader(unit) for unit in parents}


def _named(unit: Unit) -> Iterator[str]:
    for key in _NAMING:
        yield from unit.words(key)
    for key in _INSTALLING:
        yield from unit.words(key, "Install")


def _commanded(processes: list[Process]) -> Iterator[str]:
    """The units that the processes of a unit start or ask for."""
    for process in processes:
        for step in process.steps:
            yield from _of_systemctl(step.command.words)


def _of_systemctl(words: tuple[Located, ...]) -> Iterator[str]:
    given = [str(word) for word in unwrapped(words)]
    if given and given[0].rpartition("/")[2] == "systemctl" and "--user" not in given:
        named = [word for word in given[1:] if not word.startswith("-")]
        if named and named[0] in _VERBS:
            yield from (word if "." in word else f"{word}.service" for word in named[1:])


def _enabled_together(units: NamedUnits) -> Iterator[list[Unit]]:
    """The units of a plain folder that one script enables or starts in any case."""
    for source in units.files.of_kind("shell-script"):
        if not source.judged or source.template or "systemctl" not in source.text:
            continue
        commands = (command for command in shell_commands(source) if not command.depth)
        names = dict.fromkeys(name for command in commands for name in _of_systemctl(command.words))
        found = [units.candidates(name) for name in names]
        named = [only[0] for only in found if len(only) == 1 and only[0].files and _overlay(only[0]) is None]
        near = [unit for unit in named if units.files.same_robot(source, unit.where.source)]
        if len(near) > 1:
            yield near
