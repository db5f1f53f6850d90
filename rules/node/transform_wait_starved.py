"""A callback waits for a transform that only its own executor could receive.

## What it finds
`lookup_transform(..., timeout=...)` of more than 0.05 s in a callback of a Python node whose listener is the node's
own (`TransformListener(buffer, self)`), and which one thread spins. It is a warning where the lookup asks for the
time of a message (`header.stamp`) or for that of the clock, and an info where it asks for another time: then it waits
only until the first transform is there. Files that start threads, spin by hand or write to the buffer themselves are
left out.

## Why it matters on a robot
In Python the wait is a loop with `sleep`, and the transforms come in through subscriptions of the node. While the
callback waits, the executor runs none of them: what was not there when the wait began is not there when it ends. Each
message that is newer than the last transform, as nearly all are, costs the whole timeout and is then dropped,
and the commands and timers of the node come late by as much.

## Bad
```python
def on_goal(self, goal):
    transform = self.buffer.lookup_transform('map', 'base_link', goal.header.stamp, timeout=Duration(seconds=1.0))
```

## Good
```python
executor = MultiThreadedExecutor()      # the listener has a callback group of its own
executor.add_node(node)
executor.spin()
```

## When to ignore it
When the transforms of this robot are always ahead of the messages.

## References
- tf2_ros_py, buffer.py: `can_transform` waits with `sleep`
- tf2_ros_py, transform_listener.py: `spin_thread=False`, a reentrant callback group
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["tf2.ExtrapolationException: Lookup would require extrapolation into the future"])
def transform_wait_starved(robot: Robot) -> Iterator[Finding]:
    for wait in nodes.starved_waits(robot.nodes):
        source = wait.file.source
        severity = "warning" if wait.is_ahead else "info"
        name = "A lambda" if wait.callback.function is not None else f"{wait.name}()"
        yield finding(
            wait.file.span_of(wait.call),
            f"{name} waits up to {wait.seconds:g} s for a transform, and none comes in meanwhile: the executor that "
            "it blocks is the one that receives them",
            advice="look it up without a timeout and leave this message out, or spin with a MultiThreadedExecutor",
            related=[note(wait.callback.span, f"{name} is the callback of {wait.callback.kind}")],
            severity=robot.nodes.lowered(source, severity),
        )
