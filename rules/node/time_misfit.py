"""A time of rclpy is used as one of rospy, or as a number.

## What it finds
In Python nodes, what a `Time` or `Duration` of rclpy does not have: `.to_sec()`, `.secs` and the other names of rospy,
and `.sec` of the message; and sums, differences and comparisons that raise: a duration that is compared with a number,
a time from which `time.time()` is subtracted, a difference with the `stamp` of a message, and one of `now()` and
`Time()`, which is of the system clock.

## Why it matters on a robot
Python finds out when the line runs: in the watchdog that asks how old the last command is, or in the callback for the
first message. AttributeError or TypeError then leaves `spin()`, and the node ends.

## Bad
```python
if self.get_clock().now() - self.last_command > 0.5:
    self.stop()
```

## Good
```python
if self.get_clock().now() - self.last_command > Duration(seconds=0.5):
    self.stop()
```

## When to ignore it
When a class of the same name stands in for that of rclpy.

## References
- rclpy, time.py and duration.py
- https://docs.ros.org/en/jazzy/How-To-Guides/Migrating-from-ROS1/Migrating-Python-Packages.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "AttributeError: 'Time' object has no attribute 'to_sec'",
        "AttributeError: 'Duration' object has no attribute 'to_sec'",
        "TypeError: '>' not supported between instances of 'Duration' and 'float'",
        "TypeError: unsupported operand type(s) for -: 'Time' and 'float'",
        "TypeError: unsupported operand type(s) for -: 'Time' and 'Time'",
    ],
)
def time_misfit(robot: Robot) -> Iterator[Finding]:
    for types in robot.nodes.message_types:
        for found in nodes.time_misfits(types):
            error = "TypeError"
            if found.attribute is not None:
                error = f"AttributeError, as it has no '{found.attribute}'"
            yield finding(
                types.file.span_of(found.place),
                f"This {found.done}: {error}, and {found.end}",
                advice=_advice(found),
                severity=robot.nodes.lowered_if_vendored(types.file.source, "error"),
            )


def _advice(found: nodes.TimeMisfit) -> str:
    if found.attribute is not None or "number" in found.kinds:
        return "write .nanoseconds / 1e9 for the seconds of a Time or Duration"
    if any("message" in each for each in found.kinds):
        return "make a Time of the message: Time.from_msg(msg.header.stamp)"
    return "take both times from one clock: Time(clock_type=ClockType.ROS_TIME) is of that of the node"
