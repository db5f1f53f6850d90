"""A topic name has a DDS prefix or a double underscore.

## What it finds
Literal topic names that begin with the prefix that ROS itself adds to names in DDS (`rt/`, `rq/`, `rr/`), and names
with a part that contains `__`. Names with a prefix that nothing else of the tree uses are a warning.

## Why it matters on a robot
Both are legal. But `rt/scan` becomes `rt/rt/scan` in DDS: a name that is copied from a DDS tool creates a second
topic, and permissions for `rt/scan` do not cover it. `__` is reserved for names that ROS and its tools generate.

## Bad
```python
self.create_publisher(LaserScan, "rt/scan", 10)
```

## Good
```python
self.create_publisher(LaserScan, "scan", 10)
```

## When to ignore it
When the name is given by an interface that you cannot change, such as a bridge to a DDS system.

## References
- https://design.ros2.org/articles/topic_and_service_names.html
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api import topics

ROLES = ("publisher", "subscription")


@rule("warning", silent="both names are valid topics")
def topic_reserved_style(robot: Robot) -> Iterator[Finding]:
    named = [(each, each.name) for each in robot.topics.endpoints if each.role in ROLES and each.name is not None]
    roles: dict[str, set[str]] = {}
    for endpoint, name in named:
        roles.setdefault(name.lstrip("/"), set()).add(endpoint.role)
    for endpoint, name in named:
        prefix = re.match(r"/?(r[tqr]/)\w", name)
        related = topics.used_at(name, endpoint.span)
        if prefix:
            is_joined = len(roles[name.lstrip("/")]) > 1
            yield finding(
                name,
                f"'{name}' becomes rt/{name.lstrip('/')} in DDS, because ROS itself adds the prefix"
                + ("" if is_joined else f": a DDS program that uses '{name.lstrip('/')}' never meets it"),
                advice=f"remove '{prefix[1]}'",
                related=related,
                severity="info" if is_joined or robot.launch.workspace.is_vendored(endpoint.span.source) else None,
            )
        elif "__" in name:
            yield finding(
                name,
                f"'{name}' contains '__', which is reserved for names that ROS and its tools generate",
                advice="use a single underscore",
                related=related,
                severity="info",
            )
