"""MemoryHigh= is not below MemoryMax=: the kernel kills the service without throttling it first.

## What it finds
MemoryHigh= that is equal to or larger than MemoryMax=.

## Why it matters on a robot
MemoryHigh= throttles a service before MemoryMax= kills it. When the service reaches the hard limit first, the
kernel kills it without warning, in the middle of the mission.

## Bad
```ini
[Service]
MemoryHigh=2G
MemoryMax=1G
```

## Good
```ini
[Service]
MemoryHigh=1800M
MemoryMax=2G
```

## When to ignore it
Never: MemoryHigh= has no effect. To set only a hard limit, delete MemoryHigh=.

## References
- systemd.resource-control(5), MemoryHigh= and MemoryMax=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import memory


@rule("error", symptoms=["A process of this unit has been killed by the OOM killer"])
def memory_high_ge_max(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        high, most = memory(unit, "MemoryHigh"), memory(unit, "MemoryMax")
        if high is None or most is None or high.unit != most.unit or high.amount < most.amount:
            continue
        yield finding(
            high.at,
            f"MemoryHigh={high.at} is not below MemoryMax={most.at}: {unit.name} is killed before it is throttled",
            advice="set MemoryHigh= below MemoryMax=",
            related=[note(most.at, "the hard limit")],
        )
