"""Launch files that run together: those of the units of one boot, of one compose file, of one supervisor."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.systemd.units import Units

DOMAIN = "ROS_DOMAIN_ID"
_BY_HAND = (RunnerKind.SCRIPT, RunnerKind.IMAGE)
"""What people start, one at a time."""


class System(NamedTuple):
    label: str
    expansions: list[Expansion]
    """The launch files, with the arguments that they get."""
    whole: bool
    """Nothing else of ROS runs beside them."""


class _Member(NamedTuple):
    runner: Runner
    process: RosProcess


def systems(ros: RosEnvironment, units: Callable[[], Units]) -> Iterator[System]:
    launchers = (_Member(each.runner, each) for each in ros.launchers if each.runner is not None)
    members = [each for each in launchers if each.runner.kind not in _BY_HAND]
    alone = len({each.runner.kind for each in members}) == 1
    for label, group in _groups(members, units):
        expansions = [ros.expansion(start) for each in group for start in each.process.starts]
        known = [each for each in expansions if each is not None]
        if known and not _in_different_domains(group):
            whole = alone and len(known) == len(expansions) and all(each.process.starts for each in group)
            yield System(label, known, whole)


def _groups(members: list[_Member], units: Callable[[], Units]) -> Iterator[tuple[str, list[_Member]]]:
    """Those that surely run together, with a name. Units do where they are enabled together."""
    of_units = [each for each in members if each.runner.unit is not None]
    if of_units:
        yield from _of_units(of_units, units())
    systems: dict[str, list[_Member]] = {}
    for each in members:
        if each.runner.unit is None and _is_default(each.runner):
            systems.setdefault(each.runner.system, []).append(each)
    yield from systems.items()


def _of_units(members: list[_Member], units: Units) -> Iterator[tuple[str, list[_Member]]]:
    grouped = set()
    for group in units.enabled_ros_groups:
        grouped.update(group)
        if not units.any_conflict(group):
            yield "the units", [each for each in members if each.runner.unit in group]
    for runner in dict.fromkeys(each.runner for each in members):
        if runner.unit not in grouped:
            yield runner.name, [each for each in members if each.runner is runner]


def _is_default(runner: Runner) -> bool:
    """Whether it starts with its system when nothing else is asked for."""
    return runner.service is None or runner.service.get("profiles") is None


def _in_different_domains(members: list[_Member]) -> bool:
    environments = (each.process.environment for each in members)
    domains = {each.text(DOMAIN) for each in environments if each.defines(DOMAIN)}
    return len(domains - {None}) > 1
