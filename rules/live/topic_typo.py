"""A subscription waits for a topic that is published under a slightly different name.

## What it finds
Topics with subscriptions and no publisher, when the graph has exactly one other topic of the same type whose name
differs by a typing error or only by its namespace. Names that differ only in a number are not reported.

## Why it matters on a robot
Nothing fails: the subscriber waits forever. In the graph tools both names look right at a glance.

## Bad
```yaml
endpoints:
- {topic: /scan_filterd, publisher: /filter, type: sensor_msgs/msg/LaserScan}
- {topic: /scan_filtered, subscription: /slam, type: sensor_msgs/msg/LaserScan}
```

## Good
```yaml
endpoints:
- {topic: /scan_filtered, publisher: /filter, type: sensor_msgs/msg/LaserScan}
- {topic: /scan_filtered, subscription: /slam, type: sensor_msgs/msg/LaserScan}
```

## When to ignore it
When both names are intended and the publisher is not running at the moment.

## References
- ROS 2 documentation, "Remapping names"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", symptoms=["does not appear to be published yet"])
def topic_typo(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    for subscription, publisher, why in observed.meant:
        topic = publisher.topic
        differs = " (only the namespace differs)" if why == "namespace" else ""
        yield finding(
            observed.named_at(subscription),
            f"Nobody publishes {subscription.topic}, which {subscription.node} waits for; "
            f"{publisher.node} publishes {topic}{differs}",
            advice=f"use one name, or remap {subscription.topic} to {topic}",
            related=[
                note(place, said)
                for place, said in (
                    (observed.named_at(publisher), f"{publisher.node} publishes {topic}"),
                    (subscription.topic, "subscribed"),
                    (topic, "published"),
                )
                if place
                not in (
                    observed.named_at(subscription),
                    *((observed.named_at(publisher),) if said == "published" else ()),
                )
            ],
        )
