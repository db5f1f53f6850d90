"""Hardware of ros2_control answers OK although it could not reach its device.

## What it finds
In the source of a system or actuator: a failure in `read()` or `write()` that is caught, or told by the call, and after
which the method goes on and returns OK. Methods that return ERROR or DEACTIVATE anywhere, throw or count failures are
left out. It is an info where the robot descriptions of the tree name other hardware of the tree, and not this.

## Why it matters on a robot
The controller manager learns of a failure only by what `read()` and `write()` return. With OK, the states keep their
last values as if they were new, and the controllers go on with them: a base whose motor board is unplugged reports the
speed that it had, and an arm integrates against a joint that does not move.

## Bad
```cpp
try {
  bus_.poll(positions_);
} catch (const BusError & error) {
  RCLCPP_ERROR(logger_, "%s", error.what());
}
return hardware_interface::return_type::OK;
```

## Good
```cpp
} catch (const BusError & error) {
  RCLCPP_ERROR(logger_, "%s", error.what());
  if (++failures_ > 10) return hardware_interface::return_type::ERROR;
}
```

## When to ignore it
When another part of the hardware watches the device and stops the robot.

## References
- https://control.ros.org/jazzy/doc/ros2_control/hardware_interface/doc/error_handling.html
- ros2_control, resource_manager.cpp: a component whose read() or write() returns ERROR loses its controllers
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", silent="the controllers go on, and what the source logs are words of its own")
def hardware_failure_hidden(robot: Robot) -> Iterator[Finding]:
    for found in nodes.hidden_failures(robot.nodes):
        first, *others = found.places
        what = "states look as if they were new" if first.method == "read" else "commands are lost"
        yield finding(
            first.place,
            f"{first.method}() of the hardware returns OK after this failure: the controller manager does not stop "
            f"the controllers, and the {what}",
            advice="return return_type::ERROR, at least after a few failures in a row",
            related=[
                note(first.answer, "returned all the same"),
                *(note(each.place, f"the same in {each.method}()") for each in others),
            ],
            severity=robot.nodes.lowered(first.source, "warning") if found.is_described else "info",
        )
