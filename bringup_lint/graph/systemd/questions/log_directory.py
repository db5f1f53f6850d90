"""Where the ROS programs of a service write their logs, and what keeps them from it.

Per rcl (``rcl_logging_get_logging_directory()``): ROS_LOG_DIR, else ROS_HOME/log, else ~/.ros/log.
"""

from __future__ import annotations

from enum import Enum

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.systemd.filesystem import Filesystem
from bringup_lint.graph.systemd.identity import HomeOrigin
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.sandbox import View
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

OF_ROOT = ("/var/log/", "/var/lib/", "/var/cache/", "/opt/", "/srv/", "/etc/", "/usr/")
"""Where only root may create directories."""


class LogDirectory(NamedTuple):
    """Where rcl writes its logs: ROS_LOG_DIR, else ROS_HOME/log, else ~/.ros/log."""

    path: str | None
    """None: nowhere, there is no home."""
    origin: str | HomeOrigin
    """The variable that decides, ``ROS_LOG_DIR``, ``ROS_HOME`` or ``HOME``, else where the home comes from."""
    at: Located | None


class Obstacle(Enum):
    """Why the logs cannot be written."""

    NO_HOME = "there is no home"
    CLOSED = "the sandbox does not let the service write there"
    MISSING = "nothing creates the directory, and the user may not"
    UNDOCUMENTED = "it works, against the manual page"


class Unwritable(NamedTuple):
    obstacle: Obstacle
    where: Located | None
    """The line to blame; None for the unit as a whole."""
    view: View | None = None
    """What decides on the directory."""


def log_directory(units: Units, process: Process) -> LogDirectory | None:
    """Where the ROS programs of a command line log; None when that is not known."""
    environment = units.process_environment(process)
    for name, suffix in (("ROS_LOG_DIR", ""), ("ROS_HOME", "/log")):
        variable = environment.get(name)
        if variable is not None:
            path = variable.text
            known = path is not None and path.startswith("/")
            return LogDirectory(f"{path}".rstrip("/") + suffix, name, variable.value) if known else None
        if not environment.complete:
            return None
    return _in_home(units, process.unit, environment)


def _in_home(units: Units, unit: Unit, environment: Environment) -> LogDirectory | None:
    variable = environment.get("HOME")
    if variable is not None:
        return LogDirectory(f"{variable.text}/.ros/log", "HOME", variable.value) if variable.text else None
    identity = unit.identity
    if identity.user is None and not identity.dynamic:
        return None
    home = identity.home(units.users)
    if home is None:
        return None
    return LogDirectory(f"{home.path}/.ros/log" if home.path else None, home.origin, None)


@dataclass(frozen=True)
class LogAccess:
    """Whether a service can write its logs."""

    units: Units
    filesystem: Filesystem

    def obstacle(self, unit: Unit, log: LogDirectory) -> Unwritable | None:
        """What keeps the service from its log directory; None when nothing is known to."""
        identity, box = unit.identity, self.units.sandbox(unit)
        if log.path is None:
            return Unwritable(Obstacle.NO_HOME, identity.dynamic.at or identity.user)
        view = box.view(log.path)
        if view is not None and view.mode != "rw":
            own_tmpfs = view.key == "TemporaryFileSystem" and view.mode == "empty"
            return None if own_tmpfs else Unwritable(Obstacle.CLOSED, view.at, view)
        if log.origin == "ROS_LOG_DIR" and identity.is_other and log.path.startswith(OF_ROOT):
            if self.filesystem.is_created(log.path, unit) is False:
                return Unwritable(Obstacle.MISSING, log.at)
        if log.at is None and box.protect_system.value == "strict" and view is not None:
            if view.prefix in ("/home", "/root"):
                return Unwritable(Obstacle.UNDOCUMENTED, box.protect_system.at, view)
        return None
