"""WatchdogSec= in a service where no process can feed the watchdog.

## What it finds
WatchdogSec= on a service from which systemd never gets a keep-alive:

- error: the main process is ros2 launch, ros2 run or a shell, which send none, and NotifyAccess= does not let
  its children send them;
- warning: the main process is a script that is not in the tree, or a Python script that never notifies
  systemd;
- warning: NotifyAccess=all is set, but no program that the service starts notifies systemd.

WatchdogSec= alone makes systemd accept keep-alives, but only from the main process.

## Why it matters on a robot
The first keep-alive never arrives. systemd kills healthy nodes with SIGABRT every WatchdogSec= seconds, while
the robot drives.

## Bad
```ini
[Service]
ExecStart=/bin/bash /opt/robot/start-slam.sh
WatchdogSec=30
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover slam.launch.py'
WatchdogSec=30
NotifyAccess=all
```
with a node in slam.launch.py that sends WATCHDOG=1. Such a node must not ask sd_watchdog_enabled():
WATCHDOG_PID names the main process.

## When to ignore it
When a library or wrapper that is not in the tree sends WATCHDOG=1 from the main process.

## References
- systemd.service(5), WatchdogSec= and NotifyAccess=; sd_notify(3)
- <https://github.com/systemd/systemd/issues/25961>: WATCHDOG_PID and children
"""

from collections.abc import Iterator
from typing import Any

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Supervision
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import delete_lines
from bringup_lint.api.systemd import duration


@rule("error", fix="unsafe", symptoms=["Watchdog timeout (limit", "Failed with result 'watchdog'"])
def watchdog_without_notify(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        service = robot.units.supervision(unit)
        if not unit.complete or not service.watchdog_on or service.main is None or service.access.unknown:
            continue
        severity, why = _verdict(service, robot)
        if not severity:
            continue
        yield finding(
            service.watchdog.at,
            f"No keep-alive reaches systemd, {why}: {unit.name} is killed every {duration(service.watchdog.value)}",
            advice="let a process of the unit send WATCHDOG=1 and set NotifyAccess=all, or remove WatchdogSec=",
            related=[
                note(service.main.where, "the main process"),
                *([note(service.type.at, "also requires READY=1")] if service.type.at and service.notifies else ()),
                *([note(service.access.at, "limits which process may notify")] if service.access.at else ()),
            ],
            fix=_fix(unit, service, robot) if unit.editable else None,
            chain=_chain(robot, service),
            severity=severity,
            confidence="high" if severity == "error" else "medium",
        )


def _chain(robot: Robot, service: Supervision) -> tuple[Any, Any] | tuple[Related, Any]:
    """From the unit to the code of a node whose keep-alives systemd rejects."""
    if service.access.value == "all" or service.main.ros is None:
        return ()
    for node, said in robot.notify.speakers(service.main.ros):
        return robot.provenance.chain_to_node(node, note(said, "a child of launch notifies systemd"))
    return ()


def _verdict(service: Supervision, robot: Robot) -> tuple[str, str] | tuple[None, str]:
    main, access = service.main, service.access.value
    if access == "all":
        programs = [found for _, found in service.process.ros]
        if service.notifies or not main.is_ros_tool or robot.notify.within(service.process) or len(programs) != 1:
            return None, ""
        silent = robot.notify.nobody(programs[0])
        return ("warning", silent[0]) if silent else (None, "")
    if robot.notify.within(service.process) and (access == "exec" or service.as_root):
        return None, ""
    if main.is_ros_tool:
        return "error", f"because it listens only to ros2 {main.kind}, which sends none"
    if main.kind == "shell":
        return "error", "because it listens only to the shell, which sends none"
    if main.kind == "lost":
        return "warning", "because it listens only to the shell script"
    if main.kind == "python" and main.script is not None and not robot.notify.sources:
        return "warning", f"because {main.script.basename} sends none"
    return None, ""


def _fix(unit: Unit, service: Supervision, robot: Robot) -> Fix | None:
    if service.access.value != "all" and robot.notify.sources:
        if service.access.at:
            return fix("set NotifyAccess=all", (service.access.at, "all"), safe=False)
        return fix("set NotifyAccess=all", unit.new_line("Service", "NotifyAccess=all"), safe=False)
    lines = [line for line in unit.assignments("WatchdogSec", "Service") if line.value is service.watchdog.at]
    return fix("remove WatchdogSec=", *map(delete_lines, lines), safe=False) if lines else None
