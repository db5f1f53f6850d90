"""A topic has two message types.

## What it finds
Two nodes that one launch file starts. One publishes and the other subscribes to the same topic, by its full name,
but with different message types. Whether nodes of Navigation2, twist_mux, teleop_twist_joy and teleop_twist_keyboard
use `Twist` or `TwistStamped` is known from their parameters and the distribution, as far as these are known.

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
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics
from bringup_lint.api.topics import Pair
from bringup_lint.api.topics import Use


@rule("error", symptoms=["as it contains more than one type"])
def topic_type_mismatch(robot: Robot) -> Iterator[Finding]:
    told: dict[Span, list[Pair]] = {}
    for publisher, subscription in robot.topics.pairs:
        if not topics.types_differ(publisher, subscription) or subscription.shown:
            continue
        if publisher.conditional or subscription.conditional:
            continue
        if publisher.of_table and subscription.of_table:
            deciding = subscription.type_given or publisher.type_given or subscription.where
            told.setdefault(deciding, []).append(Pair(publisher, subscription))
        else:
            yield _of_source(publisher, subscription)
    yield from (_of_parameters(where, pairs) for where, pairs in told.items())


def _of_source(publisher: Use, subscription: Use) -> Finding:
    own, other = (publisher, subscription) if subscription.of_table else (subscription, publisher)
    return finding(
        own.where,
        _message(publisher, subscription),
        advice="use one type on both sides, or two topics with a node that converts",
        related=[
            note(other.where, f"{other.node.label()} {other.verb} it as {other.type}"),
            note(own.node.started.span, f"{own.node.label()} is started here"),
            *([note(other.type_given, "decides its type")] if other.type_given is not None else []),
            *([] if other.of_table else [note(other.node.started.span, f"{other.node.label()} is started here")]),
        ],
    )


def _of_parameters(where: Span, pairs: list[Pair]) -> Finding:
    """Two nodes of public packages: what decides the type, each once with all that it parts."""
    (publisher, subscription), *_ = pairs
    ends = {use.where: use for pair in pairs for use in pair}
    return finding(
        where,
        _message(publisher, subscription),
        advice="tell both nodes to use the same type",
        related=[note(use.where, f"{use.node.label()} {use.verb} {use.topic}") for use in ends.values()][:10],
    )


def _message(publisher: Use, subscription: Use) -> str:
    return (
        f"{publisher.topic} is {publisher.type} for {publisher.node.label()} and {subscription.type} for "
        f"{subscription.node.label()}: no message ever arrives"
    )
