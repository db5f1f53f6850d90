"""A joystick drives the robot without a button that is held.

## What it finds
`require_enable_button: false` for teleop_twist_joy (or a node with its parameters and a name like `joy` or `teleop`),
in parameter files that something names. Where it is only the name, and a node of the tree hears the joystick, it is
info, because that node may ask for a button.

## Why it matters on a robot
A gamepad that is dropped, sat on, tilted or lying in a bag moves the robot, and a stick that does not return to its
middle keeps it moving. The dead-man button is what stops the robot when the operator lets go.

## Bad
```yaml
teleop_twist_joy_node:
  ros__parameters:
    require_enable_button: false
    scale_linear: {x: 0.5}
```

## Good
```yaml
teleop_twist_joy_node:
  ros__parameters:
    require_enable_button: true
    enable_button: 4
    scale_linear: {x: 0.5}
```

## When to ignore it
When the transmitter itself stops the robot, or another node asks for a button.

## References
- https://github.com/ros2/teleop_twist_joy (`require_enable_button`)
- ISO 10218-1, enabling devices
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.nodes import Endpoint
from bringup_lint.api.params import operator_problems


@rule("warning", silent="the node does as it is told")
def joystick_no_deadman(robot: Robot) -> Iterator[Finding]:
    for each in operator_problems(robot.params):
        if each.kind == "deadman":
            heard = not each.name and any(is_of_joystick(endpoint) for endpoint in robot.topics.endpoints)
            yield finding(
                each.where,
                "No button has to be held: a touched or dropped gamepad moves the robot",
                advice="set require_enable_button to true, and enable_button to a button of the gamepad",
                severity="info" if heard else None,
            )


def is_of_joystick(endpoint: Endpoint) -> bool:
    return endpoint.role == "subscription" and endpoint.type == "sensor_msgs/msg/Joy"
