"""Launch files that run together: those of the units of one boot, and those of the services of one compose file."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.robot import Robot

DOMAIN = "ROS_DOMAIN_ID"
_SOURCES = ("systemd-unit", "systemd-dropin", "compose")


def systems(robot: Robot) -> Iterator[tuple[str, list[Expansion], bool]]:
    """A name, the launch files with the arguments that they get, and whether nothing else of ROS runs beside them."""
    if not robot.of_kind(*_SOURCES):
        return
    processes = [each for each in robot.ros.launchers if each.unit is not None or each.service is not None]
    alone = len({each.unit is not None for each in processes}) == 1
    for label, members in _groups(robot, processes):
        expansions = [robot.ros.expansion(start) for process in members for start in process.starts]
        known = [each for each in expansions if each is not None]
        if known and not _in_different_domains(members):
            whole = alone and len(known) == len(expansions) and all(process.starts for process in members)
            yield label, known, whole


def _groups(robot: Robot, processes: list[RosProcess]) -> Iterator[tuple[str, list[RosProcess]]]:
    units = {id(each.unit): each.unit for each in processes if each.unit is not None}
    stacked: set[int] = set()
    for stack in robot.units.enabled_ros_groups if units else ():
        stacked.update(id(unit) for unit in stack)
        if not any(robot.units.conflict(one, other) for one, other in combinations(stack, 2)):
            yield "the units", [each for each in processes if each.unit in stack]
    for unit in units.values():
        if id(unit) not in stacked:
            yield unit.name, [each for each in processes if each.unit is unit]
    services: dict[str, list[RosProcess]] = {}
    for each in processes:
        if each.service is not None and each.service.get("profiles") is None:
            services.setdefault(each.service.source.name, []).append(each)
    yield from services.items()


def _in_different_domains(processes: Iterable[RosProcess]) -> bool:
    domains = {each.environment.text(DOMAIN) for each in processes if each.environment.defines(DOMAIN)}
    return len(domains - {None}) > 1
