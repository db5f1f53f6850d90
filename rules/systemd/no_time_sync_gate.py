"""ROS starts before the clock is set.

## What it finds
A ROS service in a tree that configures a time daemon (chrony, timesyncd, ntpd, PTP), when nothing delays the
service until the clock is right. Each of these is enough:

- it is ordered after a unit that waits (`chrony-wait.service`, `systemd-time-wait-sync.service`);
- it is ordered after `time-sync.target`, and such a unit is ordered before that target;
- one of its commands waits (`chronyc waitsync`).

Simulations are exempt.

## Why it matters on a robot
A single-board computer boots with the time of its last shutdown. The daemon corrects the time seconds after
the nodes have started. The clock jumps, transforms are "in the future", buffers drop every measurement, and
timers stall or fire at once. `After=time-sync.target` alone does not help: systemd reaches it as soon as the
daemon runs.

## Bad
```ini
[Unit]
After=time-sync.target
```

## Good
```ini
[Unit]
Wants=chrony-wait.service
After=chrony-wait.service
```

## When to ignore it
When the computer has a battery-backed clock that is accurate enough, or when the robot must start without a
time source.

## References
- systemd.special(7), "time-sync.target"
- systemd-time-wait-sync.service(8)
- <https://github.com/fetchrobotics/fetch_robots/pull/71>
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import is_simulation
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Units

WAITERS = ("chrony-wait.service", "systemd-time-wait-sync.service", "ntpsec-wait.service")
DAEMONS = (
    "/etc/chrony/chrony.conf",
    "/etc/chrony.conf",
    "/etc/systemd/timesyncd.conf",
    "/etc/ntp.conf",
    "/etc/ntpsec/ntp.conf",
    "/etc/linuxptp/ptp4l.conf",
)
WAITS = regex(r"waitsync|time-wait-sync|ntp-wait|ntpwait|NTPSynchronized|pmc\s|check_clock")
SIMULATED = regex(r"use_sim_time:=[Tt]rue")


@rule(
    "warning",
    confidence="medium",
    symptoms=[
        "Lookup would require extrapolation into the future",
        "TF_OLD_DATA",
        "the timestamp on the message is earlier than all the data in the transform cache",
    ],
)
def no_time_sync_gate(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    daemon = next((path for path in DAEMONS if units.ros and configures(robot, path)), None)
    if daemon is None:
        return
    early = [unit for unit in units.ros if _starts_early(units, unit)]
    if not early:
        return
    first, *others = early
    target = [word for _, word in first.naming("After", "time-sync.target")]
    yield finding(
        target[0] if target else first.where,
        f"{daemon} sets the clock, but {first.name} does not wait for it: the time may jump while nodes run",
        advice="enable chrony-wait.service or systemd-time-wait-sync.service, and order the service after it",
        related=[
            *([note(target[0], "reached as soon as the daemon runs")] if target else []),
            *(note(unit.where, f"{unit.name} does not wait either") for unit in others),
        ],
    )


def _starts_early(units: Units, unit: Unit) -> bool:
    if unit.manager == "user" or unit.unsure_of("After", "Wants") or gated(units, unit):
        return False
    lines = [str(process.line) for process in units.processes(unit)]
    return not any(map(SIMULATED.search, lines)) and not any(map(is_simulation, (unit.stem, *lines)))


def configures(robot: Robot, path: str) -> bool | re.Match[str] | None:
    source = robot.tree.find(path)
    return source is not None and source.robot_path == path and re.search(r"^\s*[^#;!%\s\[]", source.text, re.M)


def gated(units: Units, unit: Unit) -> bool:
    if any(WAITS.search(text) for process in units.processes(unit) for text in process.texts):
        return True
    for waiter in WAITERS:
        if (units.waits_for(unit, waiter) and units.brought_in(unit, waiter)) or (
            units.brings_in(unit, waiter) and units.ordered(unit, waiter)
        ):
            return True
    return (
        any(
            other.type == "service" and "time-sync.target" in other.words("Before") and units.is_started(other)
            for other in units.judged
        )
        and units.waits_for(unit, "time-sync.target") is not None
    )
