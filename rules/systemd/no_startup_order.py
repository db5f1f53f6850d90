"""A higher layer of the robot starts together with the drivers that it needs.

## What it finds
Among the ROS services of one folder that start at boot: a service whose name marks it as a higher layer
(perception, navigation, application) and that has no order with any service of a lower layer (drivers,
sensors). Services that exclude each other are exempt.

## Why it matters on a robot
All of them start at the same time. The planner waits for transforms and scans that do not arrive yet, and its
lifecycle nodes fail to activate. Whether the robot is ready after boot depends on how fast a camera answers.

## Bad
```ini
# rover-drivers.service and rover-navigation.service, both:
[Install]
WantedBy=multi-user.target
```

## Good
```ini
# rover-navigation.service
[Unit]
Requires=rover-drivers.service
After=rover-drivers.service
```

## When to ignore it
When the higher layer waits for its inputs itself, for example because its lifecycle manager retries the
activation.

## References
- systemd.unit(5), "After="
"""

from collections.abc import Iterator
from itertools import islice

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

MOST = 10
"""Units of lower layers that a message names."""
RANK = {"hardware": 0, "perception": 1, "application": 2}


@rule("warning", confidence="medium", silent="units without an order start at once")
def no_startup_order(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for stack in units.enabled_ros_groups:
        layers = units.layers(stack)
        lowest = min((RANK.get(layers.get(unit.name, ""), 9) for unit in stack), default=9)
        for unit in stack:
            rank = RANK.get(layers.get(unit.name, ""), 0)
            if rank <= lowest:
                continue
            below = (other for other in stack if RANK.get(layers.get(other.name, ""), 9) < rank)
            lower = list(islice((other for other in below if not units.conflict(unit, other)), MOST))
            if not lower or unit.unsure_of("After", "Before"):
                continue
            if any(units.ordered(unit, other.name) for other in stack if other is not unit):
                continue
            names = ", ".join(other.name for other in lower)
            yield finding(
                unit.where,
                f"{unit.name} has no order with {names}: it starts at the same time as the drivers that it needs",
                advice=f"add After={lower[0].name}, and Requires= or Wants= for the same unit",
                related=[note(other.where, "a lower layer") for other in lower],
            )
