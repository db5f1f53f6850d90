"""A topic name in the style of DDS, or with a double underscore.

## What it finds
Literal topic names of nodes that begin with the prefix that ROS itself puts before names in DDS (`rt/`, `rq/`, `rr/`),
and names with a part that holds `__`.

## Why it matters on a robot
Both are legal. But `rt/scan` becomes `rt/rt/scan` in DDS: whoever copies the name from a DDS tool makes a second
topic, and permissions for `rt/scan` do not cover it. `__` is set apart for names that ROS and tools make up.

## Bad
```python
self.create_publisher(LaserScan, "rt/scan", 10)
```

## Good
```python
self.create_publisher(LaserScan, "scan", 10)
```

## References
- https://design.ros2.org/articles/topic_and_service_names.html
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info")
def topic_reserved_style(robot: Robot) -> Iterator[Finding]:
    for endpoint in robot.topics.endpoints:
        if endpoint.role not in ("publisher", "subscription") or endpoint.name is None:
            continue
        prefix = re.match(r"/?(r[tqr]/)\w", endpoint.name)
        if prefix:
            yield finding(
                endpoint.name,
                f"'{endpoint.name}' becomes rt/{endpoint.name.lstrip('/')} in DDS: ROS itself puts the prefix there",
                advice=f"leave '{prefix[1]}' out",
            )
        elif re.search(r"__", endpoint.name):
            yield finding(
                endpoint.name,
                f"'{endpoint.name}' holds '__', which is set apart for names that ROS and its tools make up",
                advice="use a single underscore",
            )
