"""PX4 gets the signal for offboard control too rarely.

## What it finds
Python nodes that publish `px4_msgs/msg/OffboardControlMode` from one timer alone, whose period is longer than 0.5 s.

## Why it matters on a robot
PX4 takes the stream of these messages for the sign that the companion computer is alive. With two a second or fewer it
refuses offboard mode, or leaves it in flight: COM_OF_LOSS_T (1 s) after the last one the failsafe takes over, and the
vehicle holds, returns or lands by itself.

## Bad
```python
self.create_timer(1.0, self.heartbeat)   # publishes OffboardControlMode
```

## Good
```python
self.create_timer(0.1, self.heartbeat)
```

## When to ignore it
When another program sends the signal as well.

## References
- https://docs.px4.io/main/en/flight_modes/offboard.html
- https://docs.px4.io/main/en/advanced_config/parameter_reference.html, COM_OF_LOSS_T
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["No offboard signal"])
def offboard_signal_rare(robot: Robot) -> Iterator[Finding]:
    for each in nodes.rare_signals(robot.nodes):
        yield finding(
            each.timer.span,
            f"OffboardControlMode is sent every {each.period:g} s, and PX4 wants more than two a second: "
            "it refuses or leaves offboard mode",
            advice="send it every 0.1 s",
            related=[note(each.file.span_of(each.sent), "sent here alone")],
            severity=robot.nodes.lowered(each.file.source, "warning"),
        )
