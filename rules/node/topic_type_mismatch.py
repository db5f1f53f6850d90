"""A topic has two message types.

## What it finds
Two nodes that one launch file starts. One publishes and the other subscribes to the same topic, by its full name,
but with different message types. Types that depend on a parameter (`Twist` or `TwistStamped`) are not reported.

## Why it matters on a robot
DDS connects endpoints only when name and type agree. No message arrives, and neither node logs anything.

## Bad
```python
self.create_publisher(Twist, "cmd_vel", 10)                              # in the planner
self.create_subscription(TwistStamped, "cmd_vel", self.on_command, 10)   # in the base
```

## Good
```python
self.create_publisher(TwistStamped, "cmd_vel", 10)
```

## When to ignore it
When a second publisher of the topic has the right type, and the reported pair is not meant to communicate.

## References
- DDS 1.4, 2.2.3 (topics match by name and type)
- https://design.ros2.org/articles/topic_and_service_names.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics


@rule("error", symptoms=["as it contains more than one type"])
def topic_type_mismatch(robot: Robot) -> Iterator[Finding]:
    for publisher, subscription in robot.topics.pairs:
        if not topics.types_differ(publisher, subscription):
            continue
        own, other = (publisher, subscription) if subscription.of_table else (subscription, publisher)
        if subscription.shown or own.of_table or own.conditional_source or other.conditional_source:
            continue
        yield finding(
            own.where,
            f"{publisher.topic} is {publisher.type} for {publisher.node.label()} and {subscription.type} for "
            f"{subscription.node.label()}: no message ever arrives",
            advice="use one type on both sides, or two topics with a node that converts",
            related=[
                note(other.where, f"{other.node.label()} {other.verb} it as {other.type}"),
                note(own.node.started.span, f"{own.node.label()} is started here"),
                *([] if other.of_table else [note(other.node.started.span, f"{other.node.label()} is started here")]),
            ],
        )
