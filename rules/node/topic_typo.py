"""The name of a topic or service is probably misspelt.

## What it finds
In a launch file whose nodes and topics are all known: a subscription without a publisher, while a publisher of the
same type uses nearly the same name, or the same name in another namespace. A publisher without a subscription is
checked in the same way. Names that differ only in a number are different names, and so are those of one node.

Where some nodes are not known: a subscription whose name nothing else in the tree mentions, while a source of the tree
publishes the same type under nearly the same name, or a type of the tree's own that nothing else uses.

Anywhere in the tree: a subscription that nobody publishes and a publisher that nobody takes, with one type and in one
namespace, where each is the only one for the other, one name has all words of the other or the type is one of the
tree's own, and no other file mentions either name: `imu/raw` and `imu/data_raw`.

Anywhere in the tree: a topic, service or action that one source names in one place, while exactly one name is a letter
away from it, is that of an end of the same type or in several other files, and differs in no number and no plural.

A topic in `ros2 bag record` of a launch file that nobody uses, while one with the same letters is published:
`/wheel_state` and `/wheel/state`.

An input of twist_mux that nobody feeds, while a launch file gives the velocity of another node a name that nobody
takes, which has the same words but for `cmd` and `vel`; nothing else of the tree mentions either name.

A client of a service or action that nobody offers, while all servers of its type, which is one of the tree's own, start
beside it under the same name in another namespace, or under nearly the same name: `~/start` is `/mower/start`.

## Why it matters on a robot
Nothing fails. The node waits for messages that go somewhere else, and `ros2 topic list` shows two names that look
alike. A client waits for its service forever, or gives up each call.

## Bad
```python
self.create_publisher(Twist, "cmd_vell", 10)
self.create_subscription(Twist, "cmd_vel", self.drive, 1)
```

## Good
```python
self.create_publisher(Twist, "cmd_vel", 10)
```

## When to ignore it
When both names are intended and the other side is on another computer or started later.

## References
- ROS 2 documentation, "Topic and service name mapping"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics


@rule(
    "warning",
    fix="unsafe",
    symptoms=["does not appear to be published yet", "service not available, waiting again..."],
)
def topic_typo(robot: Robot) -> Iterator[Finding]:
    for use, meant, near, correction in topics.misspelt(robot.topics):
        nobody = "Nobody publishes" if use.role == "subscription" else "Nobody subscribes to"
        yield finding(
            use.name_place or use.where,
            f"{nobody} {use.topic}, which {use.node.label()} {use.verb}: {meant.node.label()} {meant.verb} {near}",
            advice=f"{f'use {near}' if correction else 'write the same name'} on both sides, or remap one of them",
            related=[
                note(meant.name_place or meant.where, f"{near} is named here"),
                note(use.node.started.span, f"{use.node.label()} is started here"),
                *topics.used_at(use.name_place or use.where, use.where),
            ],
            chain=robot.provenance.chain_to_node(
                use.node.started, note(use.name_place or use.where, f"{use.topic} is used here")
            ),
            fix=fix(f"use {near}", correction, safe=False) if correction else None,
        )
    said = {use.topic for use, *_ in topics.misspelt(robot.topics)}
    for subscription, publisher in topics.orphans(robot.topics, said):
        yield finding(
            subscription.name,
            f"Nobody publishes {subscription.topic}, which {subscription.label} subscribes to: {publisher.label} "
            f"publishes {publisher.topic}, which nobody takes",
            advice="write the same name on both sides, or remap one of them",
            related=[
                note(publisher.name, f"{publisher.topic} is named here"),
                note(subscription.where, f"{subscription.label} subscribes here"),
            ],
        )
    places = {place.span for use, *_ in topics.misspelt(robot.topics) if isinstance(place := use.written, Located)}
    for each in topics.single_names(robot.topics):
        if each.name.span not in places:
            yield finding(
                each.name,
                f"Nothing else names {each.name}, the {each.role.replace('-', ' ')} of {each.label}: {each.meant} "
                "is a letter away",
                advice="write the same name on both sides",
                related=[note(each.place, f"{each.meant} is named here")],
            )
    for velocity, mux in topics.unfed_inputs(robot.topics, said):
        yield finding(
            mux.name_place or mux.where,
            f"Nobody publishes {mux.topic}: {mux.node.label()} waits for it, and {velocity.node.label()} sends "
            f"{velocity.topic}, which nobody takes",
            advice="write the same name on both sides",
            related=[note(velocity.name_place or velocity.where, f"{velocity.topic} is named here")],
        )
    for topic, publisher in topics.misspelt_records(robot.topics):
        yield finding(
            topic,
            f"Nobody publishes {topic}: the recording is without it, and {publisher.label} publishes {publisher.topic}",
            advice=f"record {publisher.topic}",
            related=[note(publisher.name, f"{publisher.topic} is named here")],
        )
    for use, meant in topics.unserved(robot.topics):
        yield finding(
            use.name_place or use.where,
            f"Nobody offers {use.topic}, which {use.node.label()} calls: {meant.node.label()} offers {meant.topic}",
            advice=f"call {meant.topic}, or remap one of them",
            related=[
                note(meant.name_place or meant.where, f"{meant.topic} is named here"),
                note(use.node.started.span, f"{use.node.label()} is started here"),
            ],
            chain=robot.provenance.chain_to_node(
                use.node.started, note(use.name_place or use.where, f"{use.topic} is called here")
            ),
        )
