"""A controller of ros2_control lacks a parameter that it needs.

## What it finds
Blocks of controllers of ros2_controllers, in a parameter file that also gives the controller manager their class,
without a parameter that the controller needs to be configured: `wheel_separation`, `wheel_radius` and the names of the
wheels for diff_drive_controller, `command_interfaces` and `state_interfaces` for joint_trajectory_controller, `joints`
and `interface_name` for forward_command_controller, `sensor_name` and `frame_id` for imu_sensor_broadcaster, and the
like. Also a radius or distance of wheels that is not above 0, and a block with all that a controller needs whose name
is that of no controller, while the controller has none. Silent where another parameter file gives the controller
anything. A controller that nothing else of the tree names is an info.

## Why it matters on a robot
The controller manager loads the controller and cannot configure it: the spawner ends with an error, and what it drives
does not move.

## Bad
```yaml
wheels:
  ros__parameters:
    left_wheel_names: [left_wheel_joint]
    right_wheel_names: [right_wheel_joint]
    wheel_radius: 0.05
```

## Good
```yaml
wheels:
  ros__parameters:
    left_wheel_names: [left_wheel_joint]
    right_wheel_names: [right_wheel_joint]
    wheel_separation: 0.3
    wheel_radius: 0.05
```

## When to ignore it
When something that the linter does not see gives the parameter before the controller is configured.

## References
- https://control.ros.org/jazzy/doc/ros2_controllers/doc/controllers_index.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import IncompleteController


@rule(
    "error",
    symptoms=[
        "Exception thrown during init stage with message: Invalid value set during initialization for parameter",
        "'command_interfaces' parameter is empty.",
        "'state_interfaces' parameter is empty.",
        "'joints' parameter was empty",
        "'interface_name' parameter was empty",
    ],
)
def controller_incomplete(robot: Robot) -> Iterator[Finding]:
    for each, *others in robot.plugins.incomplete_controllers:
        yield finding(
            each.where,
            _message(each, len(others)),
            advice=_advice(each),
            related=[
                note(each.typed.span, f"{each.name} is a {each.typed.value.data}"),
                *([note(each.near.key, "this name is similar")] if each.near is not None else []),
                *(note(other.where, f"'{other.missing}' is needed, too") for other in others),
            ],
            severity=None if each.used else "info",
        )


def _message(each: IncompleteController, others: int) -> str:
    if each.stray:
        return f"No controller is called {each.stray}: {each.name} gets no parameter and is not configured"
    if each.refused is not None:
        return f"{each.missing} of {each.name} is {each.refused.text}, not above 0: the controller is not configured"
    more = f" and {others} other{'s' if others > 1 else ''} that it needs" if others else ", which it needs"
    return f"{each.name} has no parameter '{each.missing}'{more}: the controller is not configured"


def _advice(each: IncompleteController) -> str:
    if each.stray:
        return f"call the block {each.name}, as the controller manager and the spawner do"
    if each.near is not None:
        return f"write {each.missing} in place of {each.near.name}"
    return f"add {each.missing}" if each.refused is None else "write the measure in metres"
