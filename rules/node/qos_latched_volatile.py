"""A map or description does not reach subscribers that start later.

## What it finds
A Python node that publishes a map (`OccupancyGrid` on `map`), `robot_description` or `tf_static` with durability
volatile, and only at start: in its constructor, or in a function that only the constructor calls. And a subscription
with durability volatile, which is what a depth alone makes, to a topic whose only publisher is a Python node of the
tree that keeps its message for those who come later (transient local) and publishes it at start.

## Why it matters on a robot
Nodes start in no fixed order. A node that subscribes a moment later never gets the map and waits for it forever. It
works on the desk and fails on every third boot.

## Bad
```python
self.map = self.create_publisher(OccupancyGrid, "map", 1)
self.map.publish(self.load(path))
```

## Good
```python
latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
self.map = self.create_publisher(OccupancyGrid, "map", latched)
self.map.publish(self.load(path))
```

## When to ignore it
When another node republishes the data, or when all subscribers are in the same process and exist before the message
is published.

## References
- ROS 2 documentation, "Quality of Service settings", durability
- REP 2003, maps are published transient local
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics

LATCHED = {
    "map": "nav_msgs/msg/OccupancyGrid",
    "robot_description": "std_msgs/msg/String",
    "tf_static": "tf2_msgs/msg/TFMessage",
}


@rule("warning", symptoms=["Waiting for map", "Waiting for robot_description"])
def qos_latched_volatile(robot: Robot) -> Iterator[Finding]:
    yield from _published(robot)
    yield from _subscribed(robot)


def _published(robot: Robot) -> Iterator[Finding]:
    for node in robot.nodes.classes:
        if not robot.nodes.is_for_robot(node.source):
            continue
        for endpoint in node.endpoints:
            name = topics.tail(endpoint.name or "")
            if endpoint.qos is None or endpoint.qos.durability != "VOLATILE":
                continue
            if endpoint.role != "publisher" or LATCHED.get(name) != endpoint.type:
                continue
            published = topics.published_at_start(robot.nodes.file_of(node), node, endpoint)
            if published:
                yield finding(
                    endpoint.qos.span,
                    f"{endpoint.name} is published once and volatile: a node that starts later never gets it",
                    advice="use a profile with durability transient local and depth 1",
                    related=[
                        *(note(span, "published here, while the node starts") for span in published),
                        *topics.used_at(endpoint.qos.span, endpoint.span),
                    ],
                )


def _subscribed(robot: Robot) -> Iterator[Finding]:
    publishers: dict[object, set[object]] = {}
    for publisher, subscription in robot.topics.pairs:
        publishers.setdefault(subscription.where, set()).add(publisher.where)
    seen = set()
    for publisher, subscription in robot.topics.pairs:
        qos, offered = subscription.qos, publisher.qos
        if qos is None or offered is None or qos.durability != "VOLATILE" or offered.durability != "TRANSIENT_LOCAL":
            continue
        if subscription.where in seen or len(publishers[subscription.where]) > 1:
            continue
        published = [] if subscription.shown else _at_start(robot, publisher)
        if published:
            seen.add(subscription.where)
            yield finding(
                subscription.qos_place,
                f"{publisher.node.label()} publishes {publisher.topic} while it starts and keeps it for those who come "
                f"later, but {subscription.node.label()} asks for durability volatile: when it starts later, it never "
                "gets this message",
                advice="subscribe with durability transient local and depth 1",
                related=[
                    note(publisher.qos_place, "kept for those who come later"),
                    *(note(span, "published here, while the node starts") for span in published),
                    *topics.used_at(subscription.qos_place, subscription.where),
                ],
                severity=robot.nodes.lowered(subscription.where.source, "warning"),
            )


def _at_start(robot: Robot, publisher: topics.Use) -> list[Span]:
    node = publisher.node.node_class
    made = [each for each in node.endpoints if each.span == publisher.where] if node is not None else []
    return topics.published_at_start(robot.nodes.file_of(node), node, made[0]) if node is not None and made else []
