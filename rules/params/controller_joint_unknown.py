"""A controller uses a joint or an interface that the robot does not have.

## What it finds
Joints in the parameters of controllers of ros2_control (`joints`, `left_wheel_names`, ...) that no description of the
tree has; joints, sensors (`sensor_name`) and GPIOs that no `<ros2_control>` has, whether the robot has them or not: of
the package of the parameter file, where it has hardware, else of the tree; command interfaces of a controller that no
`<ros2_control>` exports; hardware whose state at the start is set under a name that no `<ros2_control>` has; and, from
Jazzy on, joints in `<ros2_control>` that the robot does not have. Silent when a description includes a file that is
not in the tree, when names are computed in a way that is not understood, and when a parameter file names no joint of
the tree at all. It is an info for a controller that nothing of the tree names elsewhere, as no spawner starts it.

## Why it matters on a robot
The controller manager refuses to activate a controller whose interfaces do not exist: the spawner ends, the robot does
not move, and navigation and MoveIt wait for an action server that never comes. In Jazzy and newer, a joint in
`<ros2_control>` that the robot does not have keeps all hardware from being loaded.

## Bad
```yaml
arm_controller:
  ros__parameters:
    joints: [shoulder_joint, elbow]     # URDF: shoulder_joint, elbow_joint
```

## Good
```yaml
arm_controller:
  ros__parameters:
    joints: [shoulder_joint, elbow_joint]
```

## When to ignore it
When the description of another robot, outside of the tree, is used with the file.

## References
- https://control.ros.org/jazzy/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
- ros2_control, controller_manager.cpp ("Can't activate controller") and component_parser.cpp ("Joint '{}' not found in
  URDF")
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import UnknownJoint


@rule(
    "error",
    confidence="medium",
    symptoms=[
        "Can't activate controller '*': Command interface with '*' does not exist",
        "Joint '*' not found in URDF",
        "Unable to obtain joint command handle for",
        "Unable to obtain joint state handle for",
        "Either left wheel interfaces, right wheel interfaces are non existent",
        "State interface with key '*' does not exist",
        "Command interface with key '*' does not exist",
        "None of requested interfaces exist. Controller will not run.",
    ],
)
def controller_joint_unknown(robot: Robot) -> Iterator[Finding]:
    for each in robot.plugins.unknown_joints:
        yield finding(
            each.where,
            _message(each),
            advice=_advice(each),
            related=[note(other, "nor this one") for other in each.others[:10]],
            severity="warning" if each.kind == "component" else None if each.used else "info",
        )


def _message(each: UnknownJoint) -> str:
    if not each.controller:
        return f"The robot has no joint '{each.name}': the controller manager refuses the whole description"
    if each.kind == "joint":
        return f"No robot description has a joint '{each.name}': {each.controller} is not activated"
    if each.kind == "component":
        return (
            f"No <ros2_control> is called '{each.name}': the hardware that is meant starts in the state of all others"
        )
    if each.kind == "hardware":
        return f"No <ros2_control> has '{each.name}': {each.controller} finds no interfaces and is not activated"
    return f"No hardware takes the command '{each.name}': {each.controller} is not activated"


def _advice(each: UnknownJoint) -> str:
    if each.kind == "interface":
        return f"the description exports {each.like}"
    return f"write {each.like}" if each.like else "name the joint as the description does"
