"""Type=notify with ros2 launch: systemd rejects READY=1 from a node.

## What it finds
Type=notify or notify-reload on a service whose main process is ros2 launch, ros2 run or a shell, when
NotifyAccess= is not `all`. Without NotifyAccess=, systemd accepts notifications only from the main process.
The nodes are its children.

## Why it matters on a robot
ros2 launch itself never reports readiness, and systemd rejects the notification of a node. The start times
out, and systemd kills all nodes and starts them again. This repeats forever if the start limit is not
reached.

## Bad
```ini
[Service]
Type=notify
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```

## Good
```ini
[Service]
Type=notify
NotifyAccess=all
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```
or, when no node reports readiness, `Type=exec`.

## When to ignore it
When a wrapper that is not in this tree is the main process and sends READY=1 itself.

## References
- systemd.service(5), Type= and NotifyAccess=
- systemd, src/core/service.c: "Got notification message from PID ..., but reception only permitted for main
  PID"
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
from bringup_lint.api.systemd import Supervision
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import duration


@rule(
    "error",
    fix="unsafe",
    symptoms=["reception only permitted for main PID", "start operation timed out. Terminating."],
)
def notify_ros_launch(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        if not unit.complete or not service.notifies or service.access.value in ("all", None) or service.main is None:
            continue
        if not (service.main.is_ros_tool or service.main.kind == "shell") or robot.notify.is_heard(service):
            continue
        limit = service.start_timeout.value
        when = f" after {duration(limit)}" if limit and limit < 1e9 else ""
        main = "a shell" if service.main.kind == "shell" else f"ros2 {service.main.kind}"
        yield finding(
            service.type.at or unit.where,
            f"systemd accepts READY=1 only from the {service.access.value} process, which is {main}: it "
            f"rejects that of a node, and the start of {unit.name} times out{when}",
            advice="set NotifyAccess=all if a node sends READY=1, otherwise Type=exec",
            related=[
                note(service.main.where, f"{main} is the main process"),
                *([note(service.access.at, "limits which process may notify")] if service.access.at else ()),
                *(note(source, "notifies systemd") for source in robot.notify.sources[:3]),
            ],
            fix=_fix(robot, unit, service) if unit.editable else None,
            chain=_chain(robot, service),
        )


def _chain(robot: Robot, service: Supervision) -> tuple[Related, ...]:
    """From the unit to the code of the node whose message is refused."""
    if service.main is None or service.main.ros is None:
        return ()
    for node, said in robot.notify.notifying_nodes(service.main.ros):
        return robot.provenance.chain_to_node(node, note(said, "a child of launch notifies systemd"))
    return ()


def _fix(robot: Robot, unit: Unit, service: Supervision) -> Fix | None:
    if not robot.notify.sources:
        return fix("set Type=exec", (service.type.at, "exec"), safe=False) if service.type.at else None
    if service.access.at:
        return fix("set NotifyAccess=all", (service.access.at, "all"), safe=False)
    return fix("set NotifyAccess=all", unit.new_line("Service", "NotifyAccess=all"), safe=False)
