"""The constructor of a node loops until the program ends.

## What it finds
In Python, `while True` and `while rclpy.ok()` in the `__init__` of a node class, or in a method that it calls, without
a way out. In C++, `while (rclcpp::ok())` in the same places. Silent where the class spins itself, and for a loop under
a condition. Python loops before which callbacks were made are reported by `node/blocking-in-callback`, and C++ loops
that not even a shutdown ends by `node/loop-ignores-shutdown`.

## Why it matters on a robot
The object is never handed to `spin()`. No subscription, timer or service of the node runs, `ros2 param` and every
client wait in vain, and what comes after the constructor, such as switching the motors off at the end, is skipped. The
node appears in `ros2 node list` and publishes, so that it looks healthy.

## Bad
```python
def __init__(self):
    super().__init__('gauge')
    while rclpy.ok():
        self.measure()
```

## Good
```python
def __init__(self):
    super().__init__('gauge')
    self.create_timer(0.02, self.measure)
```

## When to ignore it
When the node only publishes, and has a thread elsewhere that spins it.

## References
- rclpy.executors, rclcpp/executor.cpp: callbacks run only while an executor spins the node
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the node publishes, but answers nothing")
def constructor_endless(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.making_loops(robot.nodes):
        through = [note(first.through, "the constructor calls it here")] if first.through is not None else []
        yield finding(
            first.span,
            f"The constructor of {first.owner} never returns from this loop: nothing spins the node, and no callback, "
            "service or parameter request of it runs",
            advice="do one step of it in the callback of a timer, and spin the node",
            related=[*through, *(note(each.span, "nor from this one") for each in others)],
            severity=robot.nodes.lowered(first.span.source, "warning"),
        )
