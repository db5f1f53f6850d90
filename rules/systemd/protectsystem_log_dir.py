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
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import LogDirectory
from bringup_lint.api.systemd import Sandbox
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import is_made
from bringup_lint.api.systemd import sandbox

OF_ROOT = ("/var/log/", "/var/lib/", "/var/cache/", "/opt/", "/srv/", "/etc/", "/usr/")


@rule(
    "error",
    fix="unsafe",
    symptoms=["Failed to get logging directory", "rcutils_mkdir", "Read-only file system"],
    aliases=["env/ros-log-dir-unwritable"],
)
def protectsystem_log_dir(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for unit in robot.units.ros:
        service, box = robot.units.supervision(unit), sandbox(unit, robot)
        processes = [
            process for process in robot.units.started(unit) if any(found.kind != "cli" for _, found in process.ros)
        ]
        if not unit.complete or len(processes) != 1 or box.own_root or service.in_container or processes[0].is_ros1:
            continue
        log = box.log_directory(processes[0])
        found = _verdict(unit, robot, box, log) if log is not None else None
        if found is None or (found[0] is log.at and log.at.span in seen):
            continue
        where, message, severity = found
        seen.add(log.at.span if log.at is not None else None)
        yield finding(
            where,
            message,
            advice="set LogsDirectory=ros2 and Environment=ROS_LOG_DIR=/var/log/ros2",
            related=_related(unit, box, log, where),
            fix=_fix(unit, log) if unit.editable and severity != "info" else None,
            severity="warning" if severity == "error" and processes[0].opaque else severity,
            confidence="medium" if processes[0].opaque or severity == "info" else "high",
        )


def _related(unit: Unit, box: Sandbox, log: LogDirectory | None, where):
    parts = [(log.at, "the log directory"), (unit.get("User"), "the user that must write there")]
    if where is log.at:
        parts.append((unit.where, f"{unit.name} logs there"))
    return [note(at, text) for at, text in parts if at is not None and at is not where]


def _verdict(
    unit: Unit, robot: Robot, box: Sandbox, log: LogDirectory
) -> tuple[Located | Span, str, str] | tuple[Located, str, str] | None:
    ends = f'every node of {unit.name} exits with "Failed to get logging directory"'
    if log.path is None:
        return (
            unit.get("DynamicUser") or unit.get("User") or unit.where,
            f"{log.why}, and ROS_LOG_DIR is not set: {ends}",
            "error",
        )
    view = box.view(log.path)
    if view is not None and view.mode in ("ro", "hidden", "empty"):
        closed = {"ro": "read-only", "hidden": "hidden", "empty": "empty and read-only"}[view.mode]
        if view.why.startswith("TemporaryFileSystem") and view.mode == "empty":
            return None
        return (
            view.at or unit.where,
            f"{view.why} makes {view.prefix} {closed}, but the logs go to {log.path}: {ends}",
            "error",
        )
    if (
        log.at is not None
        and log.why == "ROS_LOG_DIR="
        and _foreign(unit, log.path)
        and is_made(log.path, unit, robot) is False
    ):
        return log.at, f"Nothing creates {log.path}, and {unit.get('User')} may not: {ends}", "warning"
    if (
        log.at is None
        and box.protect_system.value == "strict"
        and view is not None
        and view.prefix in ("/home", "/root")
    ):
        text = (
            f"{log.path} is writable only because ProtectSystem=strict leaves {view.prefix} writable, "
            "which contradicts its manual page"
        )
        return box.protect_system.at or unit.where, text, "info"
    return None


def _foreign(unit: Unit, path: str):
    """Whether the directory is where only root may create one."""
    return unit.get("User") not in (None, "root", "0") and path.startswith(OF_ROOT)


def _fix(unit: Unit, log: LogDirectory | None) -> Fix | None:
    name = (log.path or "").removeprefix("/var/log/")
    if log.at is not None and name != log.path and "/" not in name:
        return fix("let systemd create it", unit.new_line("Service", f"LogsDirectory={name}"), safe=False)
    if log.at is None:
        lines = "LogsDirectory=ros2\nEnvironment=ROS_LOG_DIR=/var/log/ros2"
        return fix("log to /var/log/ros2", unit.new_line("Service", lines), safe=False)
    return None
