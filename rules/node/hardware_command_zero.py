"""Hardware of ros2_control commands the position 0 when it is activated.

## What it finds
In the source of a system or actuator: `on_activate` that sets the exported position commands to 0, rather than to the
measured positions, or leaves them at the 0 with which they were made. Sources that limit the first motion (a profile, a
ramp, a flag for the first command) are left out.

## Why it matters on a robot
The controller manager activates the hardware before any controller, and calls `write()` in each cycle from then on.
Until a controller claims the joints, the command is 0: all axes go there at full speed, wherever they are.

## Bad
```cpp
for (auto & command : commands_) { ... }
commands_.assign(joints, 0.0);
```

## Good
```cpp
commands_ = positions_;   // read just before
```

## When to ignore it
When 0 is where the joints always are at that time, because they were homed before.

## References
- https://control.ros.org/jazzy/doc/ros2_control/hardware_interface/doc/writing_new_hardware_component.html
- ros2_control_demos, example_1: "command and state should be equal when starting"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", silent="the joints do what they are told")
def hardware_command_zero(robot: Robot) -> Iterator[Finding]:
    for found in nodes.zeroed_commands(robot.nodes):
        yield finding(
            found.place,
            f"The hardware starts with the position commands in {found.member} at 0: "
            "write() moves all joints there at once",
            advice="read the positions in on_activate, and start with them as commands",
            related=[note(found.exported, "exported as position commands")],
            severity=robot.nodes.lowered(found.source, "warning"),
        )
