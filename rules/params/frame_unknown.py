"""A frame that no robot description and no node of the tree makes.

## What it finds
The frame of a laser scanner (`frame_id` of its driver), and the base frame of Navigation2 and slam_toolbox, that no
link of the robot descriptions is called, and that nothing else of the tree names. Silent when a description includes a
file that is not in the tree, when names of links are computed in a way that is not understood, when frames get a
prefix, and when nodes are launched that may publish transforms of their own.

## Why it matters on a robot
tf2 has no transform to the frame. Every scan is dropped, amcl and slam_toolbox do not localize, the costmaps stay
empty, and the servers of Navigation2 wait for the transform and are not activated.

## Bad
```python
Node(package='sllidar_ros2', executable='sllidar_node',
     parameters=[{'frame_id': 'laser_link'}])    # URDF: <link name="laser"/>
```

## Good
```python
Node(package='sllidar_ros2', executable='sllidar_node',
     parameters=[{'frame_id': 'laser'}])
```

## When to ignore it
When a program outside of the tree publishes the transform.

## References
- REP 105, Coordinate Frames for Mobile Platforms
- https://docs.nav2.org/setup_guides/transformation/setup_transforms.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import unknown_frames


@rule(
    "warning",
    confidence="medium",
    symptoms=[
        "Message Filter dropping message: frame '*' at time * for reason",
        "Timed out waiting for transform from * to * to become available",
        'Invalid frame ID "*" passed to canTransform argument target_frame - frame does not exist',
        'Invalid frame ID "*" passed to canTransform argument source_frame - frame does not exist',
        '"*" passed to lookupTransform argument source_frame does not exist',
        '"*" passed to lookupTransform argument target_frame does not exist',
        "Could not obtain transform from * to",
        "Could not obtain transform from * ->",
        "Failed to compute odom pose",
        "Failed to compute laser pose, aborting initialization",
        "Failed to create laser device for *; discarding scan",
        "Unable to obtain * transform. Will assume navsat device is mounted at robot's origin",
        "doesn't match global_frame_id",
        "Could not find a connection between '*' and '*' because they are not part of the same tree",
    ],
)
def frame_unknown(robot: Robot) -> Iterator[Finding]:
    for each in unknown_frames(robot.topics):
        what = "no pose of the robot is found" if each.is_base else "every scan is dropped"
        yield finding(
            each.name,
            f"No robot description has a link '{str(each.name).lstrip('/')}', and nothing else publishes it: {what}",
            advice=f"write {each.near}" if each.near else "name a link of the robot description",
            related=[note(other, "here, too") for other in each.others[:10]],
        )
