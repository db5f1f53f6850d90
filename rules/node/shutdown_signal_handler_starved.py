"""A Python signal handler never runs, or ends nothing.

## What it finds
`signal.signal(SIGTERM or SIGINT, ...)` after `rclpy.init()`, or `SignalHandlerOptions.NO`, in a program whose nodes
have no timer and that waits in `rclpy.spin`. A warning when a message or call can wake the spin, an error when
nothing can. Also a handler of a node, set after `rclpy.init()`, that neither raises nor calls what may end the program:
a warning.

## Why it matters on a robot
Python runs signal handlers only when the interpreter has control, and a spin that nothing wakes waits in C. rclpy's
own handler is disabled, so nothing happens at all: the node ignores the stop until systemd or launch kills it,
without its safe state. With subscriptions it notices the signal when the next message arrives.

## Bad
```python
rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
signal.signal(signal.SIGTERM, signal.default_int_handler)
rclpy.spin(Gripper())  # without a timer
```

## Good
```python
class Gripper(Node):
    def __init__(self):
        super().__init__('gripper')
        self.create_timer(0.2, lambda: None)  # lets signal handlers run
```

## When to ignore it
When messages arrive at a high rate for as long as the robot runs, so that the spin wakes within the stop timeout.

## References
- tried with rclpy 7.1 (Jazzy)
- https://docs.python.org/3/library/signal.html, "Execution of Python signal handlers"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.nodes import NodeSource


@rule("error", symptoms=["State 'stop-sigterm' timed out. Killing."])
def shutdown_signal_handler_starved(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        waiting = robot.nodes.without_timer(file)
        if not waiting:
            yield from _deaf(robot, file)
            continue
        for found in nodes.handler_never_runs(robot.nodes.ending(file), waiting):
            signals = " and ".join(sorted(found.signals))
            message = (
                f"The node ignores {signals} until it is killed: nothing wakes the spin, so the handler never runs"
            )
            if found.wakers:
                message = (
                    f"The node notices {signals} only when the next message or call arrives: no timer wakes the spin"
                )
            yield finding(
                file.span_of(found.place),
                message,
                advice="give the node a periodic timer (0.2 s), or call spin_once with a timeout in your own loop",
                related=[
                    note(file.span_of(found.spin.call), "this spin waits in C"),
                    *(note(node.name or node.span, "this node has no timer") for node in waiting[:3]),
                ],
                chain=nodes.chain_to(robot.nodes, file, note(file.span_of(found.place), "the signal is not noticed")),
                severity=robot.nodes.lowered(file.source, "warning" if found.wakers else "error"),
            )


def _deaf(robot: Robot, file: NodeSource) -> Iterator[Finding]:
    for deaf in nodes.deaf_handlers(robot.nodes.ending(file)):
        yield finding(
            file.span_of(deaf.call),
            f"The node goes on after {' and '.join(sorted(deaf.signals))}: this handler takes the place of that of "
            "rclpy, and ends nothing",
            advice="raise SystemExit at the end of the handler",
            related=[note(file.span_of(deaf.spin), "this spin goes on")],
            severity=robot.nodes.lowered(file.source, "warning"),
        )
