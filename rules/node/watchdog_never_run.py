"""The method that looks whether commands still arrive is never called.

## What it finds
A method of a Python node that is called a watchdog, a deadman check, a failsafe or a check of a timeout, takes no
arguments and decides something, but that no timer, no callback and no other code of the tree names.

## Why it matters on a robot
The code that should stop the motors when the operator's connection is lost is there, and does not run. The robot drives
on with its last command.

## Bad
```python
def __init__(self):
    # self.create_timer(0.1, self.check_deadman)
    self.create_subscription(Twist, "cmd_vel", self.drive, 1)

def check_deadman(self):
    if time.monotonic() - self.last > 0.5:
        self.stop()
```

## Good
```python
def __init__(self):
    self.create_timer(0.1, self.check_deadman)
    self.create_subscription(Twist, "cmd_vel", self.drive, 1)
```

## When to ignore it
When a program outside of the tree calls the method.

## References
- rclpy, `Node.create_timer`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="a method that nothing calls says nothing")
def watchdog_never_run(robot: Robot) -> Iterator[Finding]:
    for file, node, method in nodes.unrun_checks(robot.nodes):
        yield finding(
            method.name,
            f"Nothing calls {method.name}: the check never runs, and what it should stop goes on",
            advice=f"start it in the constructor, as with self.create_timer(0.1, self.{method.name})",
            related=[note(node.span, "the node that has it")],
            severity=robot.nodes.lowered(file.source, "error"),
        )
