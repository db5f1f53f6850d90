"""The name that a node gives itself is not valid.

## What it finds
A literal name in the constructor of a node that rcl rejects: a hyphen, a dot, a space or any other character than
letters, digits and underscores, a digit at the beginning, an empty name, or more than 255 characters.

## Why it matters on a robot
The constructor raises an exception, whatever name a launch file gives the node.

## Bad
```python
super().__init__('front-lidar')
```

## Good
```python
super().__init__('front_lidar')
```

## When to ignore it
Never: rcl rejects such a name in every distribution.

## References
- rclpy.validate_node_name; rmw, validate_node_name.c
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["rclpy.exceptions.InvalidNodeNameException: Invalid node name"])
def node_name_invalid(robot: Robot) -> Iterator[Finding]:
    for name in _names(robot):
        if nodes.valid_node_name(name):
            continue
        better = re.sub(r"[^A-Za-z0-9_]", "_", name.strip("/ "))
        better = f"_{better}" if better[:1].isdecimal() else better
        valid = nodes.valid_node_name(better)
        change = fix(f"write '{better}'", (name, better), safe=False)
        yield finding(
            name,
            f"'{name}' is not a valid node name: the node does not start",
            advice=f"write '{better}'" if valid else "use letters, digits and underscores",
            fix=change if valid and name and name.span.text == name else None,
        )


def _names(robot: Robot) -> Iterator[Located]:
    """The names that nodes in Python and C++ give themselves."""
    for file, node in robot.nodes.node_classes:
        if node.node_name is not None and node.node_name.span.source is file.source:
            yield node.node_name
    for source in robot.nodes.cpp:
        yield from source.names
