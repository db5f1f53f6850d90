"""The stop command is published after the context was shut down.

## What it finds
A message that is published in the `finally` or `except` of a spin, directly or through a method such as `stop()` or
an overridden `destroy_node()`, when rclpy handles the signals itself. Also a message that is published in a
callback of `context.on_shutdown` or `atexit`. A message that moves nothing is info unless a unit, a container or the
like stops the program.

## Why it matters on a robot
SIGINT and SIGTERM invalidate the context before any `finally` runs. `publish` then raises an exception, or
`rclpy.ok()` is false and the command is skipped. The stop command in the code is never sent, and the robot keeps
its last velocity.

## Bad
```python
rclpy.init()
node = Drive()
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
finally:
    node.publish_zero()
```

## Good
```python
rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
signal.signal(signal.SIGTERM, signal.default_int_handler)
node = Drive()  # with a timer: a spin that nothing wakes does not notice the signal
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
When the message is not a command and losing it does not matter, for example a last status.

## References
- tried with rclpy 7.1 (Jazzy)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

WHY = {
    "raises": 'publish raises "publisher\'s context is invalid", because the signal has invalidated the context',
    "caught": "publish fails because the signal has invalidated the context, and the exception is hidden",
    "skipped": "rclpy.ok() is false, because the signal has shut the context down",
    "on-shutdown": "the callback does not run after a signal, and on rclpy.shutdown() the context is invalid",
    "at-exit": "the signal has invalidated the context long before the process exits",
}


@rule("error", symptoms=["Failed to publish: publisher's context is invalid"], tags=["CWE-404"])
def shutdown_publish_after_context(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        told = set()
        for late in nodes.stop_after_shutdown(robot.nodes.ending(file)):
            endpoint, place = late.sending.endpoint, file.span_of(late.place)
            if late.how not in WHY or place in told:
                continue
            told.add(place)
            moves = nodes.moves(endpoint) or nodes.is_remote(endpoint)
            what = "stop command" if moves else "last message"
            steps = [note(endpoint.span, f"the publisher of {endpoint.name or 'the command'}")]
            if late.spin is not None:
                steps.insert(0, note(file.span_of(late.spin.call), "SIGINT or SIGTERM ends this spin"))
            yield finding(
                place,
                f"The {what} is never sent: {WHY[late.how]}",
                advice="init with SignalHandlerOptions.NO, turn SIGTERM into KeyboardInterrupt with "
                "signal.signal(signal.SIGTERM, signal.default_int_handler), and give the node a timer",
                related=steps,
                chain=nodes.chain_to(robot.nodes, file, note(place, f"the {what} comes too late")),
                severity=_severity(robot, file, moves),
            )


def _severity(robot: Robot, file: nodes.NodeSource, moves: bool) -> str:
    """In a raw terminal Ctrl-C is not a signal: the message is sent then, and lost only on SIGTERM. A message that
    moves nothing matters where something of the robot stops the program."""
    if robot.nodes.ending(file).is_raw_terminal or not (moves or nodes.is_stopped(robot.nodes, file)):
        return "info"
    return robot.nodes.lowered(file.source, "error" if moves else "warning")
