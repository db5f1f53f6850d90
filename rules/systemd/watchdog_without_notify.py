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

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.supervision import CERTAIN
from bringup_lint.api.supervision import Silence
from bringup_lint.api.supervision import SilentService
from bringup_lint.api.systemd import Supervision
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import delete_lines
from bringup_lint.api.systemd import duration

TEXTS = {
    Silence.ROS_TOOL: "because it listens only to ros2 {main.kind}, which sends none",
    Silence.SHELL: "because it listens only to the shell, which sends none",
    Silence.SCRIPT_OUTSIDE_TREE: "because it listens only to the shell script",
    Silence.PYTHON_SCRIPT: "because {main.script.basename} sends none",
    Silence.NOT_STARTED: "the launch file does not start {idle[0].basename}",
    Silence.NO_CODE: "no code in the tree notifies systemd",
}


@rule(
    "error",
    fix="unsafe",
    symptoms=["Watchdog timeout (limit", "Failed with result 'watchdog'", "with signal SIGABRT", "status=6/ABRT"],
)
def watchdog_without_notify(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        if not unit.has("WatchdogSec"):
            continue
        service = robot.units.supervision(unit)
        if not unit.complete or not service.watchdog_on or service.main is None or service.access.unknown:
            continue
        silent = robot.notify.silence(service)
        if silent is None or service.watchdog.at is None:
            continue
        certain = silent.why in CERTAIN
        yield finding(
            service.watchdog.at,
            f"No keep-alive reaches systemd, {_why(silent)}: {unit.name} is killed every "
            f"{duration(service.watchdog.value or 0.0)}",
            advice="let a process of the unit send WATCHDOG=1 and set NotifyAccess=all, or remove WatchdogSec=",
            related=[
                note(service.main.where, "the main process"),
                *([note(service.type.at, "also requires READY=1")] if service.type.at and service.notifies else ()),
                *([note(service.access.at, "limits which process may notify")] if service.access.at else ()),
            ],
            fix=_fix(robot, unit, service) if unit.editable else None,
            chain=_chain(robot, service),
            severity="error" if certain else "warning",
            confidence="high" if certain else "medium",
        )


def _why(silent: SilentService) -> str:
    return TEXTS[silent.why].format(main=silent.main, idle=silent.idle)


def _chain(robot: Robot, service: Supervision) -> tuple[Related, ...]:
    """From the unit to the code of a node that sends keep-alives which are refused."""
    if service.access.value == "all" or service.main is None or service.main.ros is None:
        return ()
    for node, said in robot.notify.notifying_nodes(service.main.ros):
        return robot.provenance.chain_to_node(node, note(said, "a child of launch notifies systemd"))
    return ()


def _fix(robot: Robot, unit: Unit, service: Supervision) -> Fix | None:
    if service.access.value != "all" and robot.notify.sources:
        if service.access.at:
            return fix("set NotifyAccess=all", (service.access.at, "all"), safe=False)
        return fix("set NotifyAccess=all", unit.new_line("Service", "NotifyAccess=all"), safe=False)
    lines = [line for line in unit.assignments("WatchdogSec", "Service") if line.value is service.watchdog.at]
    edits = [delete_lines(line) for line in lines]
    return fix("remove WatchdogSec=", *edits, safe=False) if edits else None
