"""A node sends to a controller of ros2_control under a name on which it does not listen.

## What it finds
Topics and actions below the name of a controller whose class a parameter file gives, which the class does not have:
`arm_controller/command` of a joint_trajectory_controller, which has `~/joint_trajectory` and
`~/follow_joint_trajectory`, or `gripper/joint_commands` of a forward_command_controller, which has `~/commands`. Silent
where another file of the tree has the same name, and for controllers of the tree's own.

## Why it matters on a robot
Nobody subscribes to the topic, or nobody serves the action: the node runs, no error is shown, and nothing moves.
`command` was the name in ROS 1.

## Bad
```python
self.create_publisher(Float64MultiArray, 'forward_position_controller/command', 10)
```

## Good
```python
self.create_publisher(Float64MultiArray, 'forward_position_controller/commands', 10)
```

## When to ignore it
When something outside of the tree takes the topic.

## References
- https://control.ros.org/jazzy/doc/ros2_controllers/doc/controllers_index.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.topics import unheard_by_controllers


@rule("warning", silent="a topic without a subscriber gives no message")
def controller_topic_unknown(robot: Robot) -> Iterator[Finding]:
    for each in unheard_by_controllers(robot.topics):
        takes = " and ".join(f"~/{name}" for name in each.takes)
        yield finding(
            each.name,
            f"{each.controller} takes only {takes}: what is sent to {each.name} reaches nobody, and nothing moves",
            advice=f"write {each.controller}/{each.takes[0]}",
            related=[note(each.typed.span, f"{each.controller} is a {each.of_class.rpartition('/')[2]}")],
        )
