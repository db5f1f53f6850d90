"""A node that moves the robot exits without a stop command.

## What it finds
A program whose node publishes velocities or efforts (`cmd_vel`, `*_command`, ...) and does nothing when it exits:
no `finally` or `except` that publishes, no signal handler, no `on_deactivate` or `on_shutdown` that publishes. A
program that leaves SIGTERM to the operating system (`SignalHandlerOptions.NO` without a handler) is also reported,
and one that takes commands for motors to pins or to an I2C bus, which keep what was written last, and stops nothing,
in Python or C++. Of C++, programs that only spin the node, without a destructor or a callback for the shutdown.
The finding is info when the tree has a mux, smoother or controller with its own timeout, or firmware that looks at the
time, when MoveIt Servo receives the topic and has an `incoming_command_timeout`, when the node only relays commands,
when a relay with a timer in the tree receives the topic, or a node in Python that keeps the time of the last command
and compares it, and when it is a lifecycle node.

## Why it matters on a robot
A motor controller that gets no message keeps the last one. When the unit is stopped or the node crashes, the robot
continues at its last velocity until something stops it.

## Bad
```python
rclpy.init()
rclpy.spin(Drive())
```

## Good
```python
rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
signal.signal(signal.SIGTERM, signal.default_int_handler)
node = Drive()  # with a timer
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
finally:
    node.publish_zero()
    node.destroy_node()
    rclpy.try_shutdown()
```

## When to ignore it
When the motor controller outside this tree stops the drives after a timeout, for example `cmd_vel_timeout` of
diff_drive_controller, and you have tested it.

## References
- tried with rclpy 7.1 (Jazzy)
- https://control.ros.org/jazzy/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html, cmd_vel_timeout
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

ADVICE = "turn SIGTERM into KeyboardInterrupt (SignalHandlerOptions.NO), and publish zero in a finally around the spin"

KEEPS = "the robot keeps its last velocity until something else stops it"


@rule("warning", confidence="medium", silent="the program ends as it was asked to", tags=["CWE-404"])
def shutdown_no_safe_state(robot: Robot) -> Iterator[Finding]:
    yield from _without_stop_command(robot)
    yield from _with_hardware(robot)
    yield from _with_hardware_in_cpp(robot)
    yield from _with_publishers(robot)


def _without_stop_command(robot: Robot) -> Iterator[Finding]:
    for file, command, spin, init, is_caught in nodes.unsafe_ends(robot.nodes):
        place = file.span_of(init) if init is not None else command.span
        message = f"The node exits without a stop command: {KEEPS}"
        if init is not None:
            message = f"SIGTERM ends the node at once and no finally runs: {KEEPS}"
        yield finding(
            place,
            message,
            advice=ADVICE,
            related=[
                note(file.span_of(spin), "after this spin nothing stops it"),
                *([note(command.span, f"publishes {command.name}")] if init is not None else []),
                *(note(runner.where, f"{runner.name} stops it") for runner in nodes.runners_of(robot.nodes, file)),
            ],
            chain=nodes.chain_to(robot.nodes, file, note(place, "no stop command")),
            severity="info" if is_caught else robot.nodes.lowered(file.source, "warning"),
        )


def _with_hardware(robot: Robot) -> Iterator[Finding]:
    for file, last, bus, command in nodes.unsafe_hardware(robot.nodes):
        place = file.span_of(last.call)
        yield finding(
            place,
            f"The node exits without stopping what it drives: {bus} keeps the last value that was written",
            advice="spin in a try that takes KeyboardInterrupt and ExternalShutdownException, and stop in its finally",
            related=[note(command.span, f"the commands of {command.name or 'this topic'} stay in force")],
            chain=nodes.chain_to(robot.nodes, file, note(place, "no stop command")),
            severity=robot.nodes.lowered(file.source, "warning"),
        )


def _with_hardware_in_cpp(robot: Robot) -> Iterator[Finding]:
    for each in nodes.unsafe_in_cpp(robot.nodes):
        yield finding(
            each.spin,
            f"The node exits without stopping what it drives: {each.bus} keeps the last value that was written",
            advice="stop it in the destructor of the node, which runs after the spin",
            related=[note(each.command.span, f"the commands of {each.command.name or 'this topic'} stay in force")],
            severity=robot.nodes.lowered(each.source, "warning"),
        )


def _with_publishers(robot: Robot) -> Iterator[Finding]:
    for sent in nodes.unsafe_publishers(robot.nodes):
        yield finding(
            sent.spin,
            f"The node exits without a stop command: {KEEPS}",
            advice="publish zero in a callback of the context's add_pre_shutdown_callback(): after it nothing is sent",
            related=[note(sent.command.span, f"publishes {sent.command.name}")],
            severity="info" if sent.is_caught else robot.nodes.lowered(sent.source, "warning"),
        )
