"""A node in a namespace uses an absolute topic name.

## What it finds
Nodes that one launch file starts in two or more namespaces, and whose source names the same topic absolutely
(`/cmd_vel`) without a remapping, so that they all share it. `/tf`, `/tf_static`, `/clock`, `/diagnostics` and
`/rosout` are meant to be shared and are not reported.

## Why it matters on a robot
The namespace separates the robots, or the arms of one robot. A name with a leading slash ignores it: a command for
one moves all of them.

## Bad
```python
self.create_subscription(Twist, "/cmd_vel", self.drive, 1)   # started in /left and in /right
```

## Good
```python
self.create_subscription(Twist, "cmd_vel", self.drive, 1)
```

## When to ignore it
When the topic is meant for all of them, for example a common stop or a common map.

## References
- https://github.com/ros-navigation/navigation2/issues/3182
- https://github.com/ros-navigation/navigation2/issues/3376
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


@rule("warning", fix="unsafe", confidence="medium", silent="both names are valid topics")
def topic_absolute_under_namespace(robot: Robot) -> Iterator[Finding]:
    for running in robot.topics.runs:
        for uses in topics.shared_by_namespaces(running):
            name = uses[0].written
            assert isinstance(name, Located)
            spaces = " and ".join(sorted({use.node.namespace or "/" for use in uses}))
            yield finding(
                name,
                f"'{name}' ignores the namespace: the same program in {spaces} shares one topic, "
                "and a message for one reaches all",
                advice=f"write '{name.lstrip('/')}', so that the namespace applies",
                related=[
                    *(note(use.node.started.span, f"{use.node.label()} is started here") for use in uses),
                    *topics.used_at(name, uses[0].where),
                ],
                fix=fix("make the name relative", (name, name.lstrip("/")), safe=False)
                if name.span.text == name
                else None,
            )
