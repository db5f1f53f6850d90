"""Two programs publish the same transform of the robot.

## What it finds
A filter of robot_localization (`ekf_node`, `ukf_node`) and a diff_drive_controller, or two filters, that one launch
file starts and that both publish the transform from the odometry frame to the robot. Both do so by default
(`publish_tf`, `enable_odom_tf`).

The same where the parameter file of the controller says so, and the filter takes its odometry as an input, or starts
beside its spawner. Silent where files for controllers of one name differ in this.

Also a filter or a diff_drive_controller whose robot frame the robot description puts below another link by a fixed
joint: every description of the tree that has the link does, and lies in the same package or is published by a launch
file that also starts the filter or the controller.

Also a `static_transform_publisher` for a link that the `robot_state_publisher` of the same bring-up publishes as well,
by a fixed joint that puts it elsewhere or below another link. The joints of macros are read with their calls.

Silent when frames, parameters or remappings are not known.

## Why it matters on a robot
Whoever asks tf2 for the pose gets now the one answer and now the other. The robot jumps between the filtered pose and
that of the wheels in every costmap and map, the farther apart the longer it drives, and navigation oscillates.

Of two static transforms each program takes the one that reaches it last, so that the lidar is in one place for the
costmap and in another one for SLAM, and may change places with every start.

## Bad
```yaml
diff_drive_controller:
  ros__parameters:
    enable_odom_tf: true
ekf_filter_node:
  ros__parameters:
    publish_tf: true
    world_frame: odom
```

## Good
```yaml
diff_drive_controller:
  ros__parameters:
    enable_odom_tf: false
ekf_filter_node:
  ros__parameters:
    publish_tf: true
    world_frame: odom
```

## When to ignore it
When one of them is turned off at run time before the robot moves.

## References
- https://control.ros.org/jazzy/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html, `enable_odom_tf`
- https://docs.ros.org/en/jazzy/p/robot_localization/doc/state_estimation_nodes.html, `publish_tf`
- geometry2, `StaticCache::insertData`: the last transform of a frame replaces the one before
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics


@rule("warning", silent="tf2 takes transforms from everybody, and the newest one counts")
def transform_published_twice(robot: Robot) -> Iterator[Finding]:
    for one, other in dict.fromkeys((*robot.topics.rival_transforms, *topics.rivals_in_files(robot.topics))):
        yield finding(
            one.where,
            f"{one.name} and {other.name} both publish the transform {one.parent} -> {one.child}: "
            "the pose of the robot jumps between the two",
            advice=f"set {one.switch} of {one.name} to false",
            related=[note(other.where, f"{other.name} publishes it, too")],
        )
    yield from _conflicts(robot)
    yield from _two_parents(robot)


def _two_parents(robot: Robot) -> Iterator[Finding]:
    for source, where, parent in topics.two_parents(robot.topics):
        yield finding(
            where,
            f"{source.name} publishes the transform {source.parent} -> {source.child}, and robot_state_publisher puts "
            f"{source.child} below {parent}: a frame has one parent, and the robot falls out of one of the two trees",
            advice=f"publish {source.parent} -> {parent}",
            related=[note(parent, f"the link above {source.child} in the robot description")],
        )


def _conflicts(robot: Robot) -> Iterator[Finding]:
    for static, joint, what in robot.topics.conflicting_transforms:
        child = static.child
        places = {
            "parent": f"{child} below {static.parent}, and robot_state_publisher puts it below {joint.parent}",
            "place": f"{child} at {_text(static.place.xyz)}, and robot_state_publisher puts it at {_text(joint.xyz)}",
            "turn": f"{child} in another direction than robot_state_publisher does",
        }
        yield finding(
            static.where,
            f"static_transform_publisher puts {places[what]}: each program takes the one that reaches it last",
            advice=f"remove the static transform, and correct the joint of {child} where it is wrong",
            related=[note(joint.where, "the joint that robot_state_publisher publishes")],
        )


def _text(place: tuple[float, ...] | None) -> str:
    return " ".join(f"{number:g}" for number in place or ())
