"""A reading that is passed on gets the time of now instead of the time at which it was taken.

## What it finds
In the callback of a laser scan, image, point cloud, IMU, range or detection: a message that takes `header.frame_id`
from the header of the message that came in, and `header.stamp` from the clock, in C++ and Python. Only for readings and
what is computed from them: scans, clouds, images, poses, transforms and odometry. Sources that speak of clocks that
differ, or of restamping, are left out, and so are stamps that a condition decides about.

## Why it matters on a robot
The stamp says when something was measured. Between that and the callback lie the exposure, the transport and the queue,
often 50 to 200 ms. Who looks up the transform for the new stamp gets where the sensor is now: at 1 rad/s an object 3 m
away moves by 30 cm for each 100 ms, and a map smears whenever the robot turns. Messages of two such topics no longer
match in a synchronizer, either.

## Bad
```python
def on_scan(self, msg):
    out = LaserScan()
    out.header.frame_id = msg.header.frame_id
    out.header.stamp = self.get_clock().now().to_msg()
```

## Good
```python
def on_scan(self, msg):
    out = LaserScan()
    out.header = msg.header
```

## When to ignore it
When the clock of what sends the readings is not synchronized with the robot.

## References
- std_msgs/Header: the stamp is that of the data
- https://www.ros.org/reps/rep-0105.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="each message is valid; only its place is wrong")
def stamp_replaced(robot: Robot) -> Iterator[Finding]:
    for found in nodes.restamped(robot.nodes):
        yield finding(
            found.stamped,
            f"{found.name} gets the time of now instead of that of {found.message}: what was measured earlier is "
            "placed where the sensor is now",
            advice=f"take the whole header of {found.message}",
            related=[note(found.frame, f"takes the frame of {found.message}")],
            severity=robot.nodes.lowered_if_vendored(found.source, "warning"),
        )
