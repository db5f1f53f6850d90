"""Hardware of ros2_control leaves its motors running when it is deactivated.

## What it finds
In the source of a system or actuator with commands for velocities or efforts: an `on_deactivate` that only logs, where
`write()` sends the commands to a device. Sources that stop the motors in `on_cleanup`, `on_shutdown` or a destructor
are left out, and trees with a firmware that may stop them by itself.

## Why it matters on a robot
After the deactivation the controller manager no longer calls `write()`, and a controller that has failed has not sent a
zero before. The motor driver goes on with the last velocity: the robot drives on until its power is cut.

## Bad
```cpp
CallbackReturn on_deactivate(const rclcpp_lifecycle::State &) override {
  RCLCPP_INFO(logger_, "Deactivated");
  return CallbackReturn::SUCCESS;
}
```

## Good
```cpp
CallbackReturn on_deactivate(const rclcpp_lifecycle::State &) override {
  driver_.set_velocities(0.0, 0.0);
  return CallbackReturn::SUCCESS;
}
```

## When to ignore it
When the motor driver stops by itself soon after the last command.

## References
- https://control.ros.org/jazzy/doc/ros2_control/hardware_interface/doc/writing_new_hardware_component.html:
  "Implement the on_deactivate method, which does the opposite of on_activate"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", silent="the deactivation succeeds, and the motors do what they were told last")
def hardware_left_moving(robot: Robot) -> Iterator[Finding]:
    for found in nodes.left_moving(robot.nodes):
        yield finding(
            found.place,
            "on_deactivate() sends no stop to the motors: they keep the velocity that was sent last",
            advice="send a zero for every joint in on_deactivate()",
            related=[note(found.sends, "sends the commands")],
            severity=robot.nodes.lowered_if_vendored(found.source, "warning"),
        )
