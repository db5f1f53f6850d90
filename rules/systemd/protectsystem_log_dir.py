"""The sandbox prevents the ROS nodes from writing their logs.

## What it finds
A ROS service that cannot write to its log directory (ROS_LOG_DIR, otherwise ROS_HOME/log, otherwise
~/.ros/log):

- error: ProtectSystem=strict makes the directory read-only, because neither ReadWritePaths= nor
  LogsDirectory= covers it;
- error: ProtectHome= closes the home that contains it;
- error: there is none, because the user is dynamic or has no home;
- warning: ROS_LOG_DIR is below a directory of root, nothing creates it, and the user may not;
- info: the default directory is writable under ProtectSystem=strict only because systemd leaves /home
  writable, which contradicts its manual page.

An error becomes a warning when the command of the service cannot be followed completely.

## Why it matters on a robot
rcl sets up logging before anything else. Without a directory to write to, every node exits at once with
"Failed to get logging directory".

## Bad
```ini
[Service]
User=rover
Environment=ROS_LOG_DIR=/var/log/rover
ProtectSystem=strict
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```

## Good
```ini
[Service]
User=rover
LogsDirectory=rover
Environment=ROS_LOG_DIR=/var/log/rover
ProtectSystem=strict
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```

## When to ignore it
When the nodes disable file logging (`--disable-external-lib-logs`), or when provisioning creates the
directory for the user.

## References
- systemd.exec(5), ProtectSystem=, ProtectHome= and LogsDirectory=
- <https://github.com/ros2/rcl_logging/issues/72>
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Place
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import HomeOrigin
from bringup_lint.api.systemd import LogAccess
from bringup_lint.api.systemd import LogDirectory
from bringup_lint.api.systemd import Obstacle
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Unwritable
from bringup_lint.api.systemd import log_directory

CLOSED = {"ro": "read-only", "hidden": "hidden", "empty": "empty and read-only"}
SEVERITY = {Obstacle.NO_HOME: "error", Obstacle.CLOSED: "error", Obstacle.MISSING: "warning"}


@rule(
    "error",
    fix="unsafe",
    symptoms=["Failed to get logging directory", "rcutils_mkdir", "Read-only file system"],
    aliases=["env/ros-log-dir-unwritable"],
)
def protectsystem_log_dir(robot: Robot) -> Iterator[Finding]:
    access = LogAccess(robot.units, robot.filesystem)
    seen = set()
    for unit in robot.units.ros:
        process = _logging(robot, unit)
        log = log_directory(robot.units, process) if process else None
        found = access.obstacle(unit, log) if log else None
        if process is None or log is None or found is None:
            continue
        where = found.where or unit.where
        if where is log.at and log.at.span in seen:
            continue
        seen.add(log.at.span if log.at is not None else None)
        severity = SEVERITY.get(found.obstacle, "info")
        yield finding(
            where,
            _message(robot, unit, log, found),
            advice="set LogsDirectory=ros2 and Environment=ROS_LOG_DIR=/var/log/ros2",
            related=_related(unit, log, where),
            fix=_fix(unit, log) if unit.editable and severity != "info" else None,
            severity="warning" if severity == "error" and process.opaque else severity,
            confidence="medium" if process.opaque or severity == "info" else "high",
        )


def _logging(robot: Robot, unit: Unit) -> Process | None:
    """The one command line of a service that starts nodes, on this machine's own file system."""
    started = [process for process in robot.units.started(unit) if any(found.kind != "cli" for _, found in process.ros)]
    if not unit.complete or len(started) != 1 or started[0].is_ros1:
        return None
    apart = robot.units.sandbox(unit).own_root or robot.units.supervision(unit).in_container
    return None if apart else started[0]


def _related(unit: Unit, log: LogDirectory, where: Place) -> list[Related]:
    parts: list[tuple[Place | None, str]] = [
        (log.at, "the log directory"),
        (unit.identity.user, "the user that must write there"),
    ]
    if where is log.at:
        parts.append((unit.where, f"{unit.name} logs there"))
    return [note(at, text) for at, text in parts if at is not None and at is not where]


def _message(robot: Robot, unit: Unit, log: LogDirectory, found: Unwritable) -> str:
    ends = f'every node of {unit.name} exits with "Failed to get logging directory"'
    if found.obstacle is Obstacle.NO_HOME:
        return f"{_homeless(robot, unit, log)}, and ROS_LOG_DIR is not set: {ends}"
    if found.obstacle is Obstacle.MISSING or found.view is None:
        return f"Nothing creates {log.path}, and {unit.identity.user} may not: {ends}"
    view = found.view
    if found.obstacle is Obstacle.CLOSED:
        return f"{view.why} makes {view.prefix} {CLOSED[view.mode]}, but the logs go to {log.path}: {ends}"
    return (
        f"{log.path} is writable only because ProtectSystem=strict leaves {view.prefix} writable, "
        "which contradicts its manual page"
    )


def _homeless(robot: Robot, unit: Unit, log: LogDirectory) -> str:
    if log.origin is HomeOrigin.DYNAMIC:
        return "DynamicUser= gives no home"
    passwd = robot.units.users.passwd
    return f"{unit.identity.user} has no home in {passwd.name if passwd else '/etc/passwd'}"


def _fix(unit: Unit, log: LogDirectory) -> Fix | None:
    name = (log.path or "").removeprefix("/var/log/")
    if log.at is not None and name != log.path and "/" not in name:
        return fix("let systemd create it", unit.new_line("Service", f"LogsDirectory={name}"), safe=False)
    if log.at is None:
        lines = "LogsDirectory=ros2\nEnvironment=ROS_LOG_DIR=/var/log/ros2"
        return fix("log to /var/log/ros2", unit.new_line("Service", lines), safe=False)
    return None
