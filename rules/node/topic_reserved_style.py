"""A topic name has a DDS prefix or a double underscore.

## What it finds
Literal topic names that begin with the prefix that ROS itself adds to names in DDS (`rt/`, `rq/`, `rr/`), and names
with a part that contains `__`.

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


@rule("info", silent="both names are valid topics")
def topic_reserved_style(robot: Robot) -> Iterator[Finding]:
    for endpoint in robot.topics.endpoints:
        if endpoint.role not in ("publisher", "subscription") or endpoint.name is None:
            continue
        prefix = re.match(r"/?(r[tqr]/)\w", endpoint.name)
        if prefix:
            yield finding(
                endpoint.name,
                f"'{endpoint.name}' becomes rt/{endpoint.name.lstrip('/')} in DDS, because ROS itself adds the prefix",
                advice=f"remove '{prefix[1]}'",
                related=topics.used_at(endpoint.name, endpoint.span),
            )
        elif re.search(r"__", endpoint.name):
            yield finding(
                endpoint.name,
                f"'{endpoint.name}' contains '__', which is reserved for names that ROS and its tools generate",
                advice="use a single underscore",
                related=topics.used_at(endpoint.name, endpoint.span),
            )
