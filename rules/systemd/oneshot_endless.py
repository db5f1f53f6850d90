"""A Type=oneshot service starts something that never ends.

## What it finds
Type=oneshot with an ExecStart= that runs `ros2 launch`, a node, or a script of the tree with an endless loop
in the foreground. It is an error where a target wants it, another unit is ordered after it, or a script starts it and
waits.

## Why it matters on a robot
A oneshot service counts as started only when its program has ended, and by default no timeout applies. The unit
stays "activating" forever, everything ordered after it waits, and Restart= never applies to a daemon that has
not started.

## Bad
```ini
[Service]
Type=oneshot
RemainAfterExit=yes
ExecStart=/usr/bin/battery-watch
```

## Good
```ini
[Service]
Type=exec
ExecStart=/usr/bin/battery-watch
Restart=always
RestartSec=5
```

## When to ignore it
When all nodes of the launch file end by themselves. A launch file that is not in the tree gives a warning, and one
whose name says that it is a task, such as `calibrate.launch.py`, gives nothing.

## References
- systemd.service(5), Type=oneshot
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit

REACHED_LATE = ("multi-user.target", "graphical.target")
"""Targets after which no service is ordered by default."""


@rule("error", fix="unsafe", symptoms=["A start job is running for"])
def oneshot_endless(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        kind = unit.get("Type")
        if kind != "oneshot" or unit.uncertain or unit.seconds("TimeoutStartSec", "TimeoutSec").at is not None:
            continue
        for process in robot.units.started(unit):
            endless = robot.units.never_ends(process)
            if endless is not None:
                sure = endless.startswith("/") or _is_known(robot, endless)
                yield finding(
                    kind,
                    f"{endless} never ends, so {unit.name} stays activating forever, and {_waiting(robot, unit)}",
                    severity=None if sure and _holds_up(robot, unit) else "warning",
                    confidence="high" if sure else "medium",
                    advice="use Type=exec",
                    related=[note(endless, "runs until it is stopped")],
                    fix=fix("use Type=exec", (kind, "exec"), safe=False),
                )
                break


def _waiting(robot: Robot, unit: Unit) -> str:
    """What does not go on: a target is ordered after all that it wants, and that is not ordered after the target."""
    target = next((name for name in unit.words("WantedBy", "Install") if name in REACHED_LATE), None)
    return f"{target} is never reached" if target else "all that waits for it too"


def _holds_up(robot: Robot, unit: Unit) -> bool:
    """Whether something waits for the end of a unit: a target, another unit of the tree, or a script that starts it."""
    if any(name in REACHED_LATE for name in unit.words("WantedBy", "Install")):
        return True
    ordered = unit.words("Before") or any(unit.name in other.words("After") for other in robot.units.judged)
    return bool(ordered) or robot.units.is_started_by_script(unit)


def _is_known(robot: Robot, target: Located) -> bool:
    """Whether the tree has the launch file that a command names."""
    return any(each.file is not None for each in robot.runners.launches if each.target is target)
