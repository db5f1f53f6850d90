"""What the service manager itself is told: systemd-system.conf(5) and its drop-ins."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING
from typing import TypeVar

from bringup_lint.parsers.unit import parse
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

Value = TypeVar("Value")


def manager_setting(robot: Robot, key: str, read: Callable[[str], Value | None]) -> tuple[Located, Value] | None:
    """The last value of a key of [Manager] that ``read`` accepts, when system.conf or a drop-in of the robot has one."""
    found = None
    for file in robot.parsed(parse, _in_order(robot)):
        for assignment in file.assignments:
            if assignment.section == "Manager" and assignment.key == key and not assignment.opaque:
                value = read(assignment.value)
                if value is not None:
                    found = (assignment.value, value)
    return found


def _in_order(robot: Robot):
    """system.conf, then the drop-ins by name. Two different main files leave no order: none counts."""
    sources = robot.of_kind("system-conf")
    main = [source for source in sources if source.basename == "system.conf"]
    ranked = sorted(main, key=lambda source: (source.robot_path or "").startswith("/etc/"))
    if len(ranked) > 1 and not all(source.robot_path for source in ranked):
        return []
    dropins = [source for source in sources if source.basename != "system.conf"]
    return [*ranked[-1:], *sorted(dropins, key=lambda source: source.basename)]
