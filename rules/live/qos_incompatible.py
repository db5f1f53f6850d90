"""The quality of service of a running publisher and subscription does not match.

## What it finds
Publishers and subscriptions of the same topic and type where the publisher offers less than the subscription
requests: reliability, durability, deadline, liveliness or lease duration, as `rmw` compares them.

## Why it matters on a robot
Both exist and the topic is listed, but not one message arrives. The only hint is one line in the log of either
side.

## Bad
```yaml
endpoints:
- {topic: /scan, publisher: /lidar/driver, type: sensor_msgs/msg/LaserScan, reliability: best_effort}
- {topic: /scan, subscription: /slam, type: sensor_msgs/msg/LaserScan, reliability: reliable}
```

## Good
```yaml
endpoints:
- {topic: /scan, publisher: /lidar/driver, type: sensor_msgs/msg/LaserScan, reliability: best_effort}
- {topic: /scan, subscription: /slam, type: sensor_msgs/msg/LaserScan, reliability: best_effort}
```

## When to ignore it
When the subscription belongs to a diagnostic tool, or when another publisher of the topic matches it.

## References
- ROS 2 documentation, "Quality of Service settings", compatibilities
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["requesting incompatible QoS. No messages will be sent to it", "offering incompatible QoS"])
def qos_incompatible(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    for topic in observed.topics:
        for publisher, subscription, conflicts in topic.pairs:
            offers = " and ".join(words(each.policy, each.offered) for each in conflicts)
            asks = " and ".join(words(each.policy, each.asked) for each in conflicts)
            where = observed.profile_at(subscription)
            related = [
                note(observed.profile_at(publisher), f"{publisher.node} publishes"),
                note(publisher.topic, f"offers {offers}"),
                note(subscription.topic, f"requests {asks}"),
            ]
            yield finding(
                where,
                f"{subscription.node} gets nothing on {topic.name}: "
                f"it requests {asks}, but {publisher.node} offers {offers}",
                advice="give both sides the same profile; for sensor data that is best effort",
                related=[each for each in related if each.span != where],
            )


def words(policy: str, value: str) -> str:
    return value if policy in ("reliability", "durability") else f"{policy} {value}"
