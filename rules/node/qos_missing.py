"""A publisher or subscription is created without a quality of service.

## What it finds
`create_publisher` with fewer than three arguments, or `create_subscription` with fewer than four, in a Python node. The
same for `queue_size=`, which is an argument of ROS 1. One finding for each function: the first call keeps the others
from being reached. It is an info in packages that others wrote and the tree only carries.

## Why it matters on a robot
The call raises a TypeError, usually in the constructor: the node never starts.

## Bad
```python
self.create_publisher(Twist, "cmd_vel", queue_size=1)
```

## Good
```python
self.create_publisher(Twist, "cmd_vel", 1)
```

## When to ignore it
When the class overrides the method and gives it a default in code that the linter does not see.

## References
- rclpy.node.Node.create_publisher and create_subscription (tried with rclpy 7.1)
"""

import ast
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.python import all_of
from bringup_lint.api.python import renamed_keyword
from bringup_lint.api.python import with_keyword


@rule(
    "error",
    fix="safe",
    symptoms=["missing 1 required positional argument: 'qos_profile'", "keyword argument 'queue_size'"],
)
def qos_missing(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        for first, *others in nodes.without_qos(robot.nodes.syntax(file)):
            function = first.call.func
            name = function.attr if isinstance(function, ast.Attribute) else "the call"
            end = nodes.end_of(robot.nodes.syntax(file), first.call)
            spans = [file.span_of(each.call) for each in (first, *others)]
            renamed = [renamed_keyword(each, "queue_size", "qos_profile") for each in spans]
            changes = [new or with_keyword(each, "qos_profile", "10") for each, new in zip(spans, renamed, strict=True)]
            change = all_of(*changes)
            yield finding(
                spans[0],
                f"{name}() {first.wrong}: it raises a TypeError, and {end}",
                advice="give it a depth such as 10, or a QoSProfile, as the last argument",
                related=[note(span, f"{each.wrong}, too") for each, span in zip(others, spans[1:], strict=True)],
                severity=robot.nodes.lowered_if_vendored(file.source, "error"),
                fix=fix("give it a quality of service", codemod=change, safe=None not in renamed) if change else None,
            )
