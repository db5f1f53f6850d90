"""A Rate sleeps in the only thread, where nothing can wake it.

## What it finds
`rate.sleep()` on a rate of `create_rate()`, in a Python program that starts no thread, has no executor with several
threads, and does not call `spin_once` either.

## Why it matters on a robot
The rate wakes up through a timer of the node, and only an executor runs timers. In the thread that should spin, the
first `sleep()` waits forever: what was published before it is the last command of the node.

## Bad
```python
rate = node.create_rate(10)
while rclpy.ok():
    node.drive()
    rate.sleep()
```

## Good
```python
node.create_timer(0.1, node.drive)
rclpy.spin(node)
```

## When to ignore it
When an imported module spins the node in a thread of its own.

## References
- rclpy.timer.Rate (tried with rclpy 7.1: the first sleep never returns)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="the thread waits forever without a message", tags=["CWE-833"])
def rate_without_spin(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        for rate, sleep in nodes.endless_rates(robot.nodes.syntax(file)):
            yield finding(
                file.span_of(sleep),
                "The rate never wakes up: its timer needs an executor, and this is the only thread",
                advice="use create_timer and spin, or spin the node in a thread of its own",
                related=[note(file.span_of(rate), "the rate is made here")],
                severity=robot.nodes.lowered(file.source, "error"),
            )
