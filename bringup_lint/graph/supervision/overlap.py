"""Services that launch the same nodes twice."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.source import Located
    from bringup_lint.source import Span

    _Command = tuple[Located | None, Located | None, frozenset[Located]]
    """Package, launch file and arguments."""

_WHOLE_ROBOT = regex(r"(?:\w+_)?(?:bringup|robot|full|all|system|stack|main)(?:\.launch)?\.(?:py|xml|ya?ml)$")
_ONE_LAYER = regex(
    r"(?:\w+_)?(?:drivers?|hardware|sensors?|perception|localization|slam|mapping|nav2?|navigation|application|planning)"
    r"(?:\.launch)?\.(?:py|xml|ya?ml)$"
)


class UnitLaunch(NamedTuple):
    """A ``ros2 launch`` of a service."""

    unit: Unit
    ros: Ros


class Overlap(NamedTuple):
    """A launch file that two services bring up."""

    first: UnitLaunch
    second: UnitLaunch
    include: Span | None
    """The include by which the first leads to the file of the second; None when both launch the same file."""


class Umbrella(NamedTuple):
    """A service for the whole robot beside services for its layers, by the names of launch files of one package."""

    whole: UnitLaunch
    layers: list[UnitLaunch]


def launches_of(group: list[Unit], units: Units) -> list[UnitLaunch]:
    """What services that run together launch, where no variable makes it another thing for each of them."""
    return [UnitLaunch(unit, ros) for unit in group for ros in units.launches(unit) if not _varies(ros)]


def _varies(ros: Ros) -> bool:
    return any("$" in word for word in (ros.package or "", ros.target or "", *ros.arguments))


def overlaps(launches: list[UnitLaunch], units: Units, launch: Launch) -> Iterator[Overlap]:
    """Each launch file that is brought up a second time, once."""
    told: set[Span] = set()
    order = {each.unit: at for at, each in reversed(list(enumerate(launches)))}
    same, started = _by_command(launches), _by_file(launches, launch)
    for first in launches:
        includes = _includes(first.ros, launch)
        including = {at: span for file, span in includes.items() for at in started.get(file, ())}
        for at in sorted({*same[_command(first.ros)], *including}):
            second = launches[at]
            where = second.ros.where.span
            if second.unit is first.unit or where in told or units.conflict(first.unit, second.unit):
                continue
            include = including.get(at)
            if include is not None or order[first.unit] < order[second.unit]:
                told.add(where)
                yield Overlap(first, second, include)


def _by_command(launches: list[UnitLaunch]) -> dict[_Command, list[int]]:
    """The numbers of the launches with each command."""
    found: dict[_Command, list[int]] = {}
    for at, each in enumerate(launches):
        found.setdefault(_command(each.ros), []).append(at)
    return found


def _command(ros: Ros) -> _Command:
    return ros.package, ros.target, frozenset(ros.arguments)


def _by_file(launches: list[UnitLaunch], launch: Launch) -> dict[int, list[int]]:
    """``id`` of a launch file -> the numbers of the launches that start it without arguments."""
    found: dict[int, list[int]] = {}
    for at, each in enumerate(launches):
        file = launch.named(each.ros.package, each.ros.target)
        if file is not None and not each.ros.arguments:
            found.setdefault(id(file), []).append(at)
    return found


def _includes(outer: Ros, launch: Launch) -> dict[int, Span]:
    """``id`` of each other launch file that the file of a command includes without condition -> the first include."""
    entry = launch.named(outer.package, outer.target)
    if entry is None or outer.arguments:
        return {}
    found: dict[int, Span] = {}
    for include in launch.expansion(entry).includes:
        if include.target is not None and include.target is not entry and not include.conditions:
            found.setdefault(id(include.target), include.action.span)
    return found


def umbrellas(launches: list[UnitLaunch], units: Units, launch: Launch) -> Iterator[Umbrella]:
    """Services that seem to launch the whole robot beside several that launch layers of it."""
    for whole in launches:
        ros = whole.ros
        if not ros.package or not _WHOLE_ROBOT.match(ros.where) or launch.named(ros.package, ros.target):
            continue
        layers = [each for each in launches if _is_layer(each, whole) and not units.conflict(whole.unit, each.unit)]
        if len(layers) > 1:
            yield Umbrella(whole, layers)


def _is_layer(each: UnitLaunch, whole: UnitLaunch) -> bool:
    return each.ros.package == whole.ros.package and bool(_ONE_LAYER.match(each.ros.where))
