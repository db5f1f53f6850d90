"""A callback of rclpy awaits asyncio.

## What it finds
`await asyncio.sleep(...)`, `gather`, `wait` or `wait_for` in a callback, in a file that does not run an asyncio
event loop.

## Why it matters on a robot
rclpy's executors run coroutines themselves, without an asyncio event loop. The await raises "no running event
loop": the action aborts, or the node exits with a traceback.

## Bad
```python
async def execute(self, goal):
    await asyncio.sleep(1.0)
```

## Good
```python
async def execute(self, goal):
    await self.arrived  # an rclpy Future that a timer or a subscription sets
```

## When to ignore it
When another module of your package runs the executor inside an asyncio event loop.

## References
- tried with rclpy 7.1 (Jazzy)
- https://github.com/ros2/rclpy/issues/962
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["RuntimeError: no running event loop"])
def asyncio_in_callback(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.node_classes:
        for callback, name, call, function in nodes.awaits_asyncio(robot.nodes.ending(file), node):
            yield finding(
                file.span_of(call),
                f"'RuntimeError: no running event loop': rclpy's executor runs {name}() without asyncio, and "
                f"{function} raises",
                advice="await an rclpy Future that a timer completes, or use a Rate in another callback group",
                related=[note(callback.span, f"{name} is the callback of {callback.kind}")],
                severity=robot.nodes.lowered(file.source, "error"),
            )
