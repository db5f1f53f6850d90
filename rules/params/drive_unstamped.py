"""Commands without a time stamp for a drive controller that takes only stamped ones.

## What it finds
For controllers of the type `diff_drive_controller/DiffDriveController`, where the tree is for Jazzy or newer: the topic
`<controller>/cmd_vel_unstamped` in remappings of launch files, and `use_stamped_vel: false` in parameter files, which
alone is a warning. Silent where a node of the tree may add the stamp (twist_stamper).

## Why it matters on a robot
Since Jazzy the controller subscribes to `~/cmd_vel` with `geometry_msgs/msg/TwistStamped` alone. Nobody listens to the
other topic, and the parameter does not exist any more: the robot does not move, and no message says why. It happens
with every workspace that comes from Humble.

## Bad
```python
Node(package='twist_mux', executable='twist_mux',
     remappings=[('cmd_vel_out', '/diff_cont/cmd_vel_unstamped')])
```

## Good
```python
Node(package='twist_mux', executable='twist_mux', parameters=[{'use_stamped': True}],
     remappings=[('cmd_vel_out', '/diff_cont/cmd_vel')])
```

## When to ignore it
When the controller is built from an older branch than that of the distribution.

## References
- ros2_controllers, diff_drive_controller.cpp, branches humble and jazzy
- https://control.ros.org/jazzy/doc/ros2_controllers/doc/migration.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="a topic without a subscriber, and a parameter that nothing declares, give no message")
def drive_unstamped(robot: Robot) -> Iterator[Finding]:
    for each in robot.plugins.unstamped_commands:
        what = "has no topic cmd_vel_unstamped" if each.is_topic else "has no parameter use_stamped_vel"
        yield finding(
            each.where,
            f"diff_drive_controller {what} in {each.distribution.capitalize()}: {each.controller} listens to "
            "~/cmd_vel with TwistStamped alone",
            advice=f"send TwistStamped to {each.controller}/cmd_vel",
            related=[note(other, "here, too") for other in each.others[:10]],
            severity=None if each.is_topic else "warning",
        )
