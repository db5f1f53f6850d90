"""A velocity that goes on when no command comes any more.

## What it finds
A node that keeps the last velocity it was sent, and whose timer or thread sends it on again and again; and code that
writes velocities to pins, to an I2C bus or to a motor driver, which keep what was written last. Messages of other
types count by their names: `MotorSpeeds`, `ThrusterCommand`; numbers by that of their topic: `thruster/command`; and
the axes of a joystick that a timer goes on with, `Joy` or a type of its own such as `JoyState`. The same for a
callback that writes velocities to a serial port or a CAN bus, unless the firmware of the tree compares times or the
controller is known to stop by itself (VESC, moteus, ros_arduino_bridge, ...); where the tree holds no firmware, it is
info. What turns a gimbal or a camera is left out. So it is for a class that nothing of the tree makes. In all cases
when nothing in the source looks at a time: no time-out, no stamp that is read, no difference of two times, no count of
the turns without a message; a time that is kept and never read is no look. A timer in Python is found in spite of such
a look when no condition comes before the call that sends the command: a watchdog that only publishes a flag does not
alter what the motors get.

## Why it matters on a robot
When the planner ends, the teleoperation loses its WiFi or the message queue runs dry, the robot drives on at its last
speed. A repeated command also defeats the time-out of the motor controller that it is sent to.

## Bad
```python
def on_twist(self, msg):
    self.command = msg

def tick(self):
    self.publisher.publish(self.command)
```

## Good
```python
def on_twist(self, msg):
    self.command, self.received_at = msg, self.get_clock().now()

def tick(self):
    late = self.get_clock().now() - self.received_at > Duration(seconds=0.5)
    self.publisher.publish(Twist() if late else self.command)
```

## When to ignore it
When the firmware of the motors stops them by itself, and the node does not repeat commands.

## References
- ros2_controllers, diff_drive_controller: cmd_vel_timeout
- Nav2, velocity smoother: velocity_timeout
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

ADVICE = "keep the time of the last command, and stop when it is older than its sender ever pauses, say half a second"


@rule("warning", confidence="medium", silent="the absence of messages is not an event", tags=["CWE-672"])
def command_no_timeout(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for found in nodes.repeated(robot.nodes):
        if found.where not in seen:
            seen.add(found.where)
            yield finding(
                found.where,
                f"{found.timer} sends {found.kept} however old it is: without new commands the robot drives on",
                advice=ADVICE,
                severity=robot.nodes.lowered(found.source, "warning"),
                related=[
                    note(found.subscription.span, f"fills {found.kept}"),
                    *([note(found.sender, "sends it")] if found.sender is not None else []),
                ],
            )
    for held in nodes.held(robot.nodes):
        keeps = "and nothing here stops the motors when no command comes" if held.is_board else "which keeps the last"
        end = "they stop only if their controller does so by itself" if held.is_board else "the robot drives on"
        yield finding(
            held.subscription.span,
            f"Velocities are written to {held.bus}, {keeps}: without new commands {end}",
            advice=ADVICE,
            related=[note(held.writer, "writes them")] if held.writer is not None else [],
            severity="info"
            if held.is_board and not nodes.has_firmware(robot.nodes)
            else robot.nodes.lowered(held.source, "warning"),
        )
