"""A publisher or subscription is created without a quality of service.

## What it finds
`create_publisher` with fewer than three arguments, or `create_subscription` with fewer than four, in a Python node. The
same for `queue_size=`, which is an argument of ROS 1. One finding for each function: the first call keeps the others
from being reached.

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
from bringup_lint.api.python import renamed_keyword
from bringup_lint.api.python import with_keyword


@rule(
    "error",
    fix="safe",
    symptoms=["missing 1 required positional argument: 'qos_profile'", "keyword argument 'queue_size'"],
)
def qos_missing(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.programs:
        for first, *others in nodes.without_qos(robot.nodes.syntax(file)):
            function = first.call.func
            name = function.attr if isinstance(function, ast.Attribute) else "the call"
            span, end = file.span_of(first.call), nodes.end_of(robot.nodes.syntax(file), first.call)
            renamed = renamed_keyword(span, "queue_size", "qos_profile")
            change = renamed or with_keyword(span, "qos_profile", "10")
            yield finding(
                span,
                f"{name}() {first.wrong}: it raises a TypeError, and {end}",
                advice="give it a depth such as 10, or a QoSProfile, as the last argument",
                related=[note(file.span_of(each.call), f"{each.wrong}, too") for each in others],
                severity=nodes.lowered(robot.nodes.purpose(file.source), "error"),
                fix=fix("give it a quality of service", codemod=change, safe=renamed is not None) if change else None,
            )
