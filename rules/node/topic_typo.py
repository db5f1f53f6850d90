"""A topic name is probably misspelt.

## What it finds
In a launch file whose nodes and topics are all known: a subscription without a publisher, while a publisher of the
same type uses nearly the same name, or the same name in another namespace. A publisher without a subscription is
checked in the same way. Names that differ only in a number are different names.

Where some nodes are not known: a subscription whose name nothing else in the tree mentions, while a source of the tree
publishes the same type under nearly the same name, or a type of the tree's own that nothing else uses.

## Why it matters on a robot
Nothing fails. The node waits for messages that go somewhere else, and `ros2 topic list` shows two names that look
alike.

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

import re
from collections import Counter
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics


def is_outvoted(count: Counter[str], topic: str, near: str) -> bool:
    """Whether more places use the other name, so that this one is the typo."""
    return count[near] > count[topic]


def is_named_elsewhere(robot: Robot, use: topics.Use) -> bool:
    """Whether another file of the tree mentions the last word of a topic, so that something else may serve it."""
    name = re.compile(rf"\b{re.escape(use.topic.rpartition('/')[2])}\b")
    return any(name.search(source.text) for source in robot.sources if source is not use.where.source)


@rule("warning", fix="unsafe", symptoms=["does not appear to be published yet"])
def topic_typo(robot: Robot) -> Iterator[Finding]:
    said: set[frozenset[Span]] = set()
    for running in sorted(robot.topics.runs, key=lambda running: not running.complete):
        used = Counter(use.topic for use in running.uses)
        for use, meant, near, evidence in topics.probable_typos(running):
            if evidence != "topics" and is_named_elsewhere(robot, use):
                continue
            if evidence == "type" and (use.type or "").partition("/")[0] not in robot.launch.workspace.packages:
                continue
            sides = frozenset(each.name_place or each.where for each in (use, meant))
            if sides in said:
                continue
            said.add(sides)
            nobody = "Nobody publishes" if use.role == "subscription" else "Nobody subscribes to"
            better = topics.corrected(use, near) if is_outvoted(used, use.topic, near) else None
            yield finding(
                use.name_place or use.where,
                f"{nobody} {use.topic}, which {use.node.label()} {use.verb}: {meant.node.label()} {meant.verb} {near}",
                advice=f"{f'use {near}' if better else 'write the same name'} on both sides, or remap one of them",
                related=[
                    note(meant.name_place or meant.where, f"{near} is named here"),
                    note(use.node.started.span, f"{use.node.label()} is started here"),
                ],
                chain=robot.provenance.chain_to_node(
                    use.node.started, note(use.name_place or use.where, f"{use.topic} is used here")
                ),
                fix=fix(f"use {near}", better, safe=False) if better else None,
            )
