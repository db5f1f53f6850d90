"""The quality of service of a publisher and a subscription does not match.

## What it finds
Two nodes that one launch file starts. One publishes and the other subscribes to the same topic, by its full name
after namespaces, parameters and remappings. The publisher offers less than the subscription requests: best effort
instead of reliable, volatile instead of transient local, a longer deadline or lease duration, or automatic instead
of manual liveliness.

The profiles come from Python and C++ sources, `qos_overrides` in parameters, RViz configurations and a table of
common drivers. A subscription of RViz is a warning, because only a person misses the data. Silent where any part is
not known.

Also subscriptions in the sources of nodes that are started apart from each other, by several launch files, by scripts
or by hand, when every publisher of the topic in the tree offers less than they request. Left out are topics that a
public driver publishes by default, and those that a launch file remaps.

Also reliable subscriptions to `/fmu/out/...` that no node of the tree publishes: PX4 publishes all of them best effort.

## Why it matters on a robot
The two discover each other but never connect. No message arrives and nothing fails: the only sign is one warning at
startup.

## Bad
```python
self.create_publisher(LaserScan, "scan", qos_profile_sensor_data)     # in the driver: best effort
self.create_subscription(LaserScan, "scan", self.on_scan, 10)         # in the safety node: reliable
```

## Good
```python
self.create_subscription(LaserScan, "scan", self.on_scan, qos_profile_sensor_data)
```

## When to ignore it
When the subscription is optional and another publisher of the topic matches it.

## References
- ROS 2 documentation, "Quality of Service settings", compatibilities
- `rclpy.qos.qos_check_compatible`
- https://github.com/ros2/rviz/issues/1122
- https://docs.px4.io/main/en/middleware/uxrce_dds.html, "PX4 ROS 2 QoS Settings"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics


@rule(
    "error",
    symptoms=[
        "offering incompatible QoS. No messages will be received from it",
        "requesting incompatible QoS. No messages will be sent to it",
        "Last incompatible policy: RELIABILITY",
    ],
)
def qos_incompatible(robot: Robot) -> Iterator[Finding]:
    pairs = [(*each, next(topics.conflicts_of(*each), None)) for each in robot.topics.pairs]
    served: dict[object, list[topics.Use]] = {}
    for publisher, subscription, conflict in pairs:
        if conflict is None and not topics.types_differ(publisher, subscription):
            served.setdefault(subscription.where, []).append(publisher)
    for publisher, subscription, conflict in pairs:
        if conflict is None or topics.types_differ(publisher, subscription):
            continue
        others = {each.node.label() for each in served.get(subscription.where, ())} - {publisher.node.label()}
        own, other = (publisher, subscription) if subscription.of_table else (subscription, publisher)
        words = {publisher: "offers", subscription: "requests"}
        yield finding(
            own.qos_place,
            f"{publisher.node.label()} publishes {publisher.topic} with {conflict.policy} '{conflict.offered}', "
            f"but {subscription.node.label()} requests '{conflict.asked}': {_lost(others)}",
            severity="warning" if subscription.shown or others else None,
            advice=f"give both sides the same {conflict.policy}, or let the subscription request less",
            chain=robot.provenance.chain_to_node(
                own.node.started, note(own.qos_place, f"{own.node.label()} {words[own]} it")
            ),
            related=[
                note(other.qos_place, f"{other.node.label()} {words[other]} it here"),
                note(own.node.started.span, f"{own.node.label()} is started here"),
                *([] if other.of_table else [note(other.node.started.span, f"{other.node.label()} is started here")]),
                *topics.used_at(own.qos_place, own.where),
                *topics.used_at(other.qos_place, other.where),
            ],
        )
    for each in topics.unserved_apart(robot.topics):
        yield apart(robot, each)
    yield from of_autopilot(robot)


def apart(robot: Robot, each: topics.UnservedApart) -> Finding:
    """A subscription that no publisher of the tree serves, whatever starts them."""
    publisher, *more = each.publishers
    subscription, conflict = each.subscription, each.conflict
    return finding(
        subscription.where,
        f"{publisher.label} publishes {publisher.topic} with {conflict.policy} '{conflict.offered}', but "
        f"{subscription.label} requests '{conflict.asked}': no message ever arrives",
        severity=robot.nodes.lowered(subscription.where.source, "error"),
        advice=f"give both sides the same {conflict.policy}, or let the subscription request less",
        related=[
            note(publisher.where, f"{publisher.label} publishes it"),
            *[note(end.qos.span, f"the profile of {end.label}") for end in (publisher, subscription) if end.qos],
            *[note(other.where, f"{other.label} publishes it like that, too") for other in more[:10]],
            *[note(other.where, f"the same goes for {other.topic}") for other in each.others[:10]],
        ],
    )


def _lost(others: set[str]) -> str:
    """What arrives all the same, from other publishers of the topic."""
    if not others:
        return "no message ever arrives"
    return f"none of these messages ever arrives, only those of {' and '.join(sorted(others))}"


def of_autopilot(robot: Robot) -> Iterator[Finding]:
    for source, (first, *others) in topics.too_reliable(robot.nodes):
        yield finding(
            first.span,
            f"PX4 publishes {first.name} with reliability 'best effort', but this requests 'reliable': "
            "no message ever arrives",
            advice="subscribe with qos_profile_sensor_data, or rclcpp::SensorDataQoS()",
            related=[note(each.span, f"nor any of {each.name}") for each in others[:10]],
            severity=robot.nodes.lowered(source, "error"),
        )
