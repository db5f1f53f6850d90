"""Nothing on the robot publishes a subscribed topic.

## What it finds
A topic to which a node subscribes and that no node publishes, on a robot whose units or compose services, and all
their nodes, are known. Not reported: topics of tools and people (`goal_pose`, `joy`, commands, triggers), topics
that are known only from the table of common nodes, and names that any other source of the tree publishes.

Also, anywhere in the tree, a subscription to a message of the tree's own that is made in any case, while all nodes of
the tree that publish this message do so under names with another last part, and no other file has that of the
subscription. Silent where a publisher of the message takes its name from a parameter or an expression.

## Why it matters on a robot
The callback never runs. A filter, a watchdog or a localisation that depends on it waits forever.

## Bad
```python
Node(package="mower", executable="safety", remappings=[("scan", "scan_filtered")]),   # and no filter is started
```

## Good
```python
Node(package="laser_filters", executable="scan_to_scan_filter_chain"),
Node(package="mower", executable="safety", remappings=[("scan", "scan_filtered")]),
```

## When to ignore it
When another computer, a simulator or a tool publishes the topic.

## References
- ROS 2 documentation, "Understanding topics"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics


@rule("warning", confidence="medium", symptoms=["does not appear to be published yet"])
def topic_unconnected(robot: Robot) -> Iterator[Finding]:
    for running in robot.topics.runs:
        if not running.whole:
            continue
        near = {each.use.topic for each in topics.probable_typos(running)}
        for use in topics.without_publisher(running):
            if use.topic not in near and topics.tail(use.topic) not in robot.topics.published_anywhere:
                yield finding(
                    use.name_place or use.where,
                    f"Nobody publishes {use.topic}: {use.node.label()} waits for it forever",
                    advice="start a publisher, or check the remappings on both sides",
                    related=[
                        note(use.node.started.span, f"{use.node.label()} is started here"),
                        *topics.used_at(use.name_place or use.where, use.where),
                    ],
                )
    if not robot.of_kind("python-node", "cpp-node"):
        return
    near_ones = [use for use, *_ in topics.misspelt(robot.topics)]
    told = {use.where for use in near_ones}
    told |= {each.where for each, _ in topics.orphans(robot.topics, {use.topic for use in near_ones})}
    for subscription, publishers in topics.unpublished(robot.topics):
        if subscription.where in told:
            continue
        first, others = publishers[0], len({each.topic for each in publishers}) - 1
        also = f" and {others} other topic{'s' * (others > 1)}" if others else ""
        yield finding(
            subscription.name,
            f"Nobody publishes {subscription.topic}: {subscription.label} waits for it forever, and "
            f"{subscription.type} is published as {first.topic}{also} alone",
            advice="write the same name on both sides, or remap one of them",
            related=[
                note(first.name, f"{first.topic} is named here"),
                note(subscription.where, f"{subscription.label} subscribes here"),
            ],
        )
