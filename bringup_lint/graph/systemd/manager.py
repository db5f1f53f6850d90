"""What the service manager itself is told: systemd-system.conf(5) and its drop-ins."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING
from typing import TypeVar

from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

Value = TypeVar("Value")


def manager_setting(robot: Robot, key: str, read: Callable[[str], Value | None]) -> tuple[Located, Value] | None:
    """The last value of a key of [Manager] that ``read`` accepts. Files of several robots side by side leave
    no order: none counts."""
    daemons = robot.system_conf
    return daemons[0].get(key, read=read) if len(daemons) == 1 and daemons[0].certain else None
