"""An absolute topic name in a node that is launched in a namespace.

## What it finds
Nodes that one launch file starts in two or more namespaces, and whose sources name one topic absolutely (`/cmd_vel`)
without a remapping, so that they all share it. `/tf`, `/tf_static`, `/clock`, `/diagnostics` and `/rosout` are meant to
be shared.

## Why it matters on a robot
The namespace keeps the robots, or the arms of one robot, apart. A name with a slash in front leaves it: the command for
one moves all.

## Bad
```python
self.create_subscription(Twist, "/cmd_vel", self.drive, 1)   # started in /left and in /right
```

## Good
```python
self.create_subscription(Twist, "cmd_vel", self.drive, 1)
```

## References
- https://github.com/ros-navigation/navigation2/issues/3182
- https://github.com/ros-navigation/navigation2/issues/3376
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics


@rule("warning", fix="unsafe", confidence="medium")
def topic_absolute_under_namespace(robot: Robot) -> Iterator[Finding]:
    for running in robot.topics.runs:
        for uses in topics.shared_by_namespaces(running):
            first = uses[0]
            spaces = " and ".join(sorted({use.node.namespace for use in uses}))
            yield finding(
                first.written,
                f"'{first.written}' ignores the namespace: the same program in {spaces} shares one topic, and what is "
                "meant for one reaches all",
                advice=f"write '{first.written.lstrip('/')}', so that the namespace counts",
                related=[note(use.node.started.span, f"{use.node.label()} is started here") for use in uses],
                fix=fix("make the name relative", (first.written, first.written.lstrip("/")), safe=False),
            )
