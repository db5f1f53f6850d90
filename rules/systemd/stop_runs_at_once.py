"""A service that sets something up counts as ended as soon as it is done.

## What it finds
A service whose ExecStart= only sets something up and ends (`ip link set`, `modprobe`, `sysctl`, writes to /sys, or a
script of such commands), without `RemainAfterExit=yes`, and

- with ExecStop=: systemd runs it at once;
- with another Type= than oneshot, where another unit of the tree is ordered after it.

## Why it matters on a robot
systemd runs ExecStop= when the main process has ended, also by itself: can0 goes down again in the moment in which it
has come up. With Type=simple, the default, the units that are ordered after the service start as soon as it is forked:
the driver opens can0 before it is up, sometimes.

## Bad
```ini
[Service]
ExecStart=/usr/sbin/ip link set can0 up type can bitrate 500000
ExecStop=/usr/sbin/ip link set can0 down
```

## Good
```ini
[Service]
Type=oneshot
RemainAfterExit=yes
ExecStart=/usr/sbin/ip link set can0 up type can bitrate 500000
ExecStop=/usr/sbin/ip link set can0 down
```

## When to ignore it
When ExecStop= is meant to run right after ExecStart=.

## References
- systemd.service(5), Type=, RemainAfterExit= and ExecStop=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import set_up

ENDING = (None, "simple", "exec", "oneshot")


@rule("warning", silent="the unit is inactive after a successful start")
def stop_runs_at_once(robot: Robot) -> Iterator[Finding]:
    after = _ordered(robot)
    for unit in robot.units.services:
        kind = unit.get("Type")
        if unit.uncertain or kind not in ENDING or unit.flag("RemainAfterExit") or _starts_again(robot, unit):
            continue
        started = robot.units.started(unit)
        work = [set_up(process) for process in started]
        if not started or None in work:
            continue
        first = work[0] or started[0].program
        stop = unit.get("ExecStop")
        if stop is not None:
            yield finding(
                stop,
                f"ExecStop= of {unit.name} runs at once: the service has ended when its set-up is done",
                advice="write Type=oneshot and RemainAfterExit=yes",
                related=[note(first, "does its work and ends")],
            )
        elif kind != "oneshot" and (later := _ordered_after(after, unit)):
            yield finding(
                kind or started[0].line,
                f"{later[0].span.source.basename} is to start after {unit.name}, but does not wait for its set-up: "
                f"Type={kind or 'simple'} counts as started when it is forked",
                advice="write Type=oneshot and RemainAfterExit=yes",
                related=[note(each, "is ordered after it") for each in later[:5]],
            )


def _starts_again(robot: Robot, unit: Unit) -> bool:
    """Whether systemd or a timer runs the work again and again, so that it is meant to end."""
    return unit.get("Restart") in ("always", "on-success") or unit.name in robot.units.triggered


def _ordered(robot: Robot) -> dict[str, list[tuple[Unit, Located]]]:
    """Unit -> where units of the tree say that they start after it."""
    found: dict[str, list[tuple[Unit, Located]]] = {}
    for other in robot.units.judged:
        for word in other.words("After"):
            found.setdefault(str(word), []).append((other, word))
    return found


def _ordered_after(after: dict[str, list[tuple[Unit, Located]]], unit: Unit) -> list[Located]:
    """Where other units of the tree say that they start after this one."""
    same = after.get(unit.name, ())
    return [word for other, word in same if other is not unit and other.manager == unit.manager]
