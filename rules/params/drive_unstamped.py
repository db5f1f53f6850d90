"""Commands without a time stamp for a drive controller that takes only stamped ones.

## What it finds
For controllers of the type `diff_drive_controller/DiffDriveController`, where the tree is for Jazzy or newer: the topic
`<controller>/cmd_vel_unstamped` in remappings of launch files, and `use_stamped_vel: false` in parameter files, which
alone is a warning. Silent where a node of the tree may add the stamp (twist_stamper). In all distributions since
Humble: nodes launched beside the controller that send `Twist` to the topic for `TwistStamped`, or the other way round;
and that send to `cmd_vel_unstamped` of a controller without `use_stamped_vel: false`. What twist_mux, teleop_twist_joy,
teleop_twist_keyboard and the servers of Navigation2 send is known from their parameters and the distribution.

## Why it matters on a robot
Since Jazzy the controller subscribes to `~/cmd_vel` with `geometry_msgs/msg/TwistStamped` alone. Nobody listens to the
other topic, and the parameter does not exist any more: the robot does not move, and no message says why. It happens
with every workspace that comes from Humble. There, the parameter chooses between the two topics, and is true by
default. DDS connects endpoints of one type only.

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
from bringup_lint.api.topics import Unheard
from bringup_lint.api.topics import unheard_commands


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
    for unheard in unheard_commands(robot.topics):
        yield _finding(unheard)


def _finding(unheard: Unheard) -> Finding:
    drive, (first, *others) = unheard.drive, unheard.uses
    wanted, sent = drive.type.rpartition("/")[2], str(first.type).rpartition("/")[2]
    what = f"sends {sent} there" if first.topic == drive.topic else f"sends to {first.topic}"
    return finding(
        first.name_place or first.where,
        f"{drive.controller} takes {wanted} on {drive.topic} alone, and {first.node.label()} {what}: "
        "the robot does not move",
        advice=f"send {wanted} to {drive.topic}",
        related=[
            note(drive.where, f"decides what {drive.controller} listens to"),
            *(note(use.name_place or use.where, f"{use.node.label()}, too") for use in others[:10]),
        ],
    )
