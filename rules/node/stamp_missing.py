"""A reading is published with the time 0.

## What it finds
Odometry, joint states, IMU, laser, point cloud, range, GPS and magnetometer readings, and transforms, that Python and
C++ nodes make, fill and publish without a time stamp; and images that a node takes itself from a camera. Only messages
of which every use is seen: one that is handed to something else may get its stamp there. What robot_localization does
is said where the tree uses it. Positions of GPS are an info where neither it nor a synchronizer of
message_filters is in use: they are read as they come.

## Why it matters on a robot
The stamp stays 0, which is 1970. robot_localization ignores such readings, `robot_state_publisher` and tf2 place the
joints and frames in the past, where a lookup for now finds nothing, and no reading can be joined with that of another
sensor. Nothing logs that the stamp is missing: echo shows the messages, and the robot does not localize.

## Bad
```python
odom = Odometry()
odom.header.frame_id = 'odom'
self.publisher.publish(odom)
```

## Good
```python
odom = Odometry()
odom.header.stamp = self.get_clock().now().to_msg()
odom.header.frame_id = 'odom'
self.publisher.publish(odom)
```

## When to ignore it
When the only receiver of the messages does not look at their time.

## References
- robot_localization, ros_filter.cpp: readings that are not newer than the last reset (0 at start) are dropped
- tf2, cache.cpp: a lookup finds transforms by their stamps
- https://www.ros.org/reps/rep-0105.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

SYNCHRONIZER = regex(
    r"\b(?:Approximate|Exact)Time(?:Synchronizer)?\b|\b(?:Time)?Synchronizer\b",
    hints="Synchronizer ApproximateTime ExactTime",
)
"""What message_filters joins messages by, which looks at their stamps."""
IGNORED = "robot_localization ignores it"
HARM = {
    "geometry_msgs/msg/TransformStamped": "a lookup for now finds no transform",
    "nav_msgs/msg/Odometry": IGNORED,
    "sensor_msgs/msg/Imu": IGNORED,
    "geometry_msgs/msg/TwistWithCovarianceStamped": IGNORED,
    "sensor_msgs/msg/JointState": "the transforms of the joints lie in the past",
}
PLAIN = frozenset({"sensor_msgs/msg/NavSatFix"})
"""What is shown to people, or read as it comes, where no filter takes it."""
OTHERS = "it cannot be transformed or joined with other sensors"


@rule("warning", silent="the messages arrive, and only those who look at their time drop them")
def stamp_missing(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.unstamped(robot.nodes):
        kind, harm = first.type.rpartition("/")[2], HARM.get(first.type, OTHERS)
        is_localized = uses_robot_localization(robot)
        if harm == IGNORED and not is_localized:
            harm = OTHERS
        yield finding(
            first.made,
            f"{kind} is published with the time 0, because nothing sets its stamp: {harm}",
            advice="set header.stamp to the time of the reading, or to that of the node's clock",
            related=[
                note(first.sent, "published here"),
                *(note(each.made, f"no stamp in this {each.type.rpartition('/')[2]} either") for each in others),
            ],
            severity="info"
            if first.type in PLAIN and not is_localized and not is_synchronized(robot, kind)
            else robot.nodes.lowered(first.made.source, "warning"),
        )


def uses_robot_localization(robot: Robot) -> bool:
    """Whether a launch file or a package of the tree names it."""
    kinds = ("launch-python", "launch-xml", "launch-yaml", "ros-package")
    return any("robot_localization" in source.text for source in robot.files.of_kind(*kinds))


def is_synchronized(robot: Robot, kind: str) -> bool:
    """Whether a source of the tree that joins messages by their stamps has this kind of message."""
    sources = robot.of_kind("python-node", "cpp-node")
    return any(source.matches(SYNCHRONIZER) and kind in source.said for source in sources)
