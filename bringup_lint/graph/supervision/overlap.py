"""Services that launch the same nodes twice."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.source import Span

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
    """What services that run together launch."""
    return [UnitLaunch(unit, ros) for unit in group for ros in units.launches(unit)]


def overlaps(launches: list[UnitLaunch], units: Units, launch: Launch) -> Iterator[Overlap]:
    """Each launch file that is brought up a second time, once."""
    told: set[Span] = set()
    order = {each.unit: at for at, each in reversed(list(enumerate(launches)))}
    for first in launches:
        for second in launches:
            where = second.ros.where.span
            if second.unit is first.unit or units.conflict(first.unit, second.unit) or where in told:
                continue
            include = _including(first.ros, second.ros, launch)
            earlier = order[first.unit] < order[second.unit]
            if include is not None or (_is_same(first.ros, second.ros) and earlier):
                told.add(where)
                yield Overlap(first, second, include)


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


def _is_same(one: Ros, other: Ros) -> bool:
    return one.target == other.target and one.package == other.package and set(one.arguments) == set(other.arguments)


def _including(outer: Ros, inner: Ros, launch: Launch) -> Span | None:
    """The unconditional include by which the launch file of one command leads to that of the other."""
    entry = launch.named(outer.package, outer.target)
    wanted = launch.named(inner.package, inner.target)
    if entry is None or wanted is None or entry is wanted or outer.arguments or inner.arguments:
        return None
    for include in launch.expansion(entry).includes:
        if include.target is wanted and not include.conditions:
            return include.action.span
    return None
