"""When a driver crashes, the service that requires it keeps running.

## What it finds
A ROS service with `Requires=`, but not `BindsTo=`, of a ROS service whose name marks it as a driver or a
safety function.

## Why it matters on a robot
`Requires=` propagates an explicit stop or restart, but not a crash. When the base driver crashes, navigation
keeps planning on old data and sends commands as soon as the driver is back. `BindsTo=` together with `After=`
stops navigation with the driver.

## Bad
```ini
[Unit]
Requires=base-driver.service
After=base-driver.service
```

## Good
```ini
[Unit]
BindsTo=base-driver.service
After=base-driver.service
```

## When to ignore it
When the service detects the loss of the driver itself, for example by a topic deadline, and brings the robot
to a safe state.

## References
- systemd.unit(5), "Requires=", "BindsTo="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", fix="unsafe", silent="the service that requires the driver keeps running")
def crash_not_propagated(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    layers = units.layers(units.ros)
    for unit in units.ros:
        bound = set(unit.words("BindsTo"))
        for line in unit.assignments("Requires"):
            for word in line.value.words():
                other = units.find(word, unit)
                if word in bound or other not in units.ros or layers.get(other.name) not in ("hardware", "safety"):
                    continue
                alone = line.value.split() == [word]
                edits = [(line.key, "BindsTo")] if alone else [line.without(word), (line.end, f"\nBindsTo={word}")]
                yield finding(
                    word,
                    f"Requires= does not notice a crash: when {word} dies, {unit.name} keeps running",
                    advice=f"use BindsTo={word} together with After={word}",
                    related=[note(other.where, "the service that may crash")],
                    fix=fix("replace Requires= with BindsTo=", *edits, safe=False),
                )
