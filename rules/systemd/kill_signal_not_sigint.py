"""systemd stops ros2 launch with a signal that makes it abandon its nodes.

## What it finds
A service that runs ros2 launch and is stopped with a signal other than SIGINT: KillSignal= is not set
(SIGTERM) or names another signal. One-shot services and containers are exempt.

## Why it matters on a robot
On SIGINT, ros2 launch runs its shutdown handlers and stops its nodes: SIGINT, then SIGTERM, then SIGKILL. On
SIGTERM it exits at once. The nodes then die without reaching their safe state, or keep running.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
KillSignal=SIGINT
TimeoutStopSec=20
```

## When to ignore it
When every node handles SIGTERM, and KillMode=control-group sends it to all of them.

## References
- systemd.kill(5), KillSignal=
- <https://github.com/ros2/launch/issues/666>
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

THEN = {
    "control-group": "and every node gets the signal at the same time",
    "mixed": "and systemd kills them with SIGKILL",
    "process": "and they keep running",
    "none": "and they keep running",
}


@rule(
    "warning",
    fix="unsafe",
    symptoms=["State 'stop-sigterm' timed out. Killing.", "using SIGTERM or SIGQUIT can result in orphaned processes"],
)
def kill_signal_not_sigint(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        launches = robot.units.launches(unit)
        signal = service.kill_signal
        if not launches or not unit.complete or signal.value in ("SIGINT", None) or unit.get("Type") == "oneshot":
            continue
        if service.in_container or (signal.at is None and unit.get("KillSignal")):
            continue
        change = (signal.at, "SIGINT") if signal.at else unit.new_line("Service", "KillSignal=SIGINT")
        yield finding(
            signal.at or unit.where,
            f"{unit.name} is stopped with {signal.value}: ros2 launch exits without stopping "
            f"its nodes, {THEN.get(service.kill_mode.value or '', THEN['control-group'])}",
            advice="set KillSignal=SIGINT",
            related=[note(found.where, "the unit starts ros2 launch here") for found in launches],
            fix=fix("set KillSignal=SIGINT", change) if unit.editable else None,
        )
