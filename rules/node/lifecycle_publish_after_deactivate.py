"""A lifecycle node deactivates its publisher before it publishes the stop command.

## What it finds
In `on_deactivate`, `on_shutdown`, `on_cleanup` or `on_error`: a call of `super().on_deactivate()`, or of
`on_deactivate()` of a lifecycle publisher, and after it a message on that publisher.

## Why it matters on a robot
A lifecycle publisher that is not active silently drops its messages. The code shows a stop command, but the motors
keep their last velocity.

## Bad
```python
def on_deactivate(self, state):
    super().on_deactivate(state)
    self.pub.publish(Twist())
    return TransitionCallbackReturn.SUCCESS
```

## Good
```python
def on_deactivate(self, state):
    self.pub.publish(Twist())
    return super().on_deactivate(state)
```

## When to ignore it
Never for a command: the message is dropped. Delete the line if the message is not needed.

## References
- tried with rclpy 7.1 (Jazzy)
- https://design.ros2.org/articles/node_lifecycle.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning", fix="unsafe", symptoms=["Trying to publish message on the topic *, but the publisher is not activated"]
)
def lifecycle_publish_after_deactivate(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.node_classes:
        if not node.is_lifecycle:
            continue
        for found in nodes.publish_after_deactivate(robot.nodes.syntax(file), node):
            place = file.span_of(found.publish)
            moving = nodes.moves(found.endpoint)
            yield finding(
                place,
                "The message is silently dropped, because its publisher is no longer active"
                + (": the motors keep moving" if moving else ""),
                advice="publish first, then deactivate",
                related=[
                    note(file.span_of(found.deactivate), "deactivated here"),
                    note(found.endpoint.span, "a lifecycle publisher"),
                ],
                fix=nodes.swap(file, found.deactivate, found.publish),
                severity=robot.nodes.lowered(file.source, "warning"),
            )
