"""A reading that guards a motion, however old it is.

## What it finds
A node that keeps what a scanner, a range sensor, a point cloud, the odometry or a sensor with messages of its own
(`WindSensor`) sends in one callback, and publishes velocities or commands (`WinchCmd`) from another one which uses what
was kept: a timer, a thread, or the callback of the velocities that it passes on. Found when nothing in the source looks
at a time: no stamp, no time-out, no difference of two times. It is an info where it sends only commands that are
neither velocities nor for motors, and sets no speed in them: whether the last value will do is a matter of what they
move.

## Why it matters on a robot
When the scanner stops, its last reading stays: the way that was free then is free forever, and the robot drives on at
full speed. Before the first reading it is the same where the start value means a free way, such as infinity.

## Bad
```python
def on_scan(self, scan):
    self.nearest = min(scan.ranges)

def on_command(self, command):
    self.pub.publish(command if self.nearest > 0.4 else Twist())
```

## Good
```python
def on_scan(self, scan):
    self.nearest, self.seen = min(scan.ranges), self.get_clock().now()

def on_command(self, command):
    is_new = self.seen is not None and self.get_clock().now() - self.seen < Duration(seconds=0.3)
    self.pub.publish(command if is_new and self.nearest > 0.4 else Twist())
```

## When to ignore it
When something behind the node stops the robot when the sensor fails, such as Nav2's collision monitor.

## References
- Nav2, collision_monitor: source_timeout
- https://www.ros.org/reps/rep-0105.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", silent="the absence of messages is not an event", tags=["CWE-672"])
def reading_age(robot: Robot) -> Iterator[Finding]:
    for found in nodes.stale_readings(robot.nodes):
        kind = (found.subscription.type or "").rpartition("/")[2]
        first = f", and before the first one at {found.until_first}" if found.until_first else ""
        does, end = ("moves the robot", "stop") if found.drives else ("sends commands", "send what is safe")
        yield finding(
            found.used,
            f"{found.mover} {does} by {found.kept} however old it is: without new {kind} messages it stays "
            f"at its last value{first}",
            advice=f"keep the time of the reading, and {end} when it is older than a few of its periods",
            related=[note(found.subscription.span, f"fills {found.kept}")],
            severity=robot.nodes.lowered(found.source, "warning") if found.drives else "info",
        )
