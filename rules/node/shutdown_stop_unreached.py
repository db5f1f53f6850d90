"""A signal ends spin() with an exception: the stop command after it never runs.

## What it finds
Python programs that call `rclpy.spin()` outside every `try`, and after it publish a velocity, clean up pins, stop
motors or write to the bus or port that drives them, also in a method such as an overridden `destroy_node()`.

## Why it matters on a robot
`spin()` does not return when the node is told to end: SIGINT raises KeyboardInterrupt, and SIGTERM raises
ExternalShutdownException. Launch, systemd and Docker end nodes like that. Python leaves the function at once, the
motors keep their last speed, and the pins keep their level. The code looks as if it stopped the robot, and a test in
which `spin()` returns never happens.

## Bad
```python
rclpy.spin(node)
node.motors.stop()
```

## Good
```python
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
finally:
    node.motors.stop()
```

## When to ignore it
When something else stops the motors as soon as the process ends.

## References
- rclpy, executors.py: `ExternalShutdownException`
- tried with rclpy 7.1 (Jazzy)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

OF_MESSAGE = "publish the stop command in a finally, with SignalHandlerOptions.NO so that the context is still valid"
OF_HARDWARE = "spin in a try that takes KeyboardInterrupt and ExternalShutdownException, and stop in its finally"


@rule("warning", silent="the process exits as if all had gone well", tags=["CWE-404"])
def shutdown_stop_unreached(robot: Robot) -> Iterator[Finding]:
    for file, stop, spin, is_motion in nodes.unreached_stops(robot.nodes):
        place = file.span_of(stop)
        yield finding(
            place,
            "SIGINT and SIGTERM skip this stop: they end spin() with an exception, and the last command stays in force",
            advice=OF_MESSAGE if is_motion else OF_HARDWARE,
            related=[note(file.span_of(spin.call), "raises KeyboardInterrupt or ExternalShutdownException")],
            chain=nodes.chain_to(robot.nodes, file, note(place, "the stop is not reached")),
            severity=robot.nodes.lowered(file.source, "warning"),
        )
