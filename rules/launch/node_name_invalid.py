"""A node name is not valid.

## What it finds
Literal node names that are empty, start with a digit, contain characters other than letters, digits and
underscores, or are longer than 255 characters. A name that is made from the default of an argument is not reported
when every launch file that includes the file passes another value.

## Why it matters on a robot
launch rejects the name, or the process exits at once with an error.

## Bad
```python
Node(package='demo', executable='talker', name='front-camera')
```

## Good
```python
Node(package='demo', executable='talker', name='front_camera')
```

## When to ignore it
Never: rmw rejects such a name in every distribution.

## References
- rmw, `rmw_validate_node_name`
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import Started

VALID = regex(r"[A-Za-z_][A-Za-z0-9_]{0,254}\Z")


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "node name must not contain characters other than alphanumerics or '_'",
        "Error while expanding or validating node name or namespace for",
    ],
)
def node_name_invalid(robot: Robot) -> Iterator[Finding]:
    for node in robot.launch.nodes:
        name = launch.literal_text(node.name)
        if name is None or VALID.match(name) or not node.is_node:
            continue
        if name.span.text != name and _is_valid_where_included(robot, node):
            continue
        better = re.sub(r"[^A-Za-z0-9_]", "_", name.strip("/ "))
        better = f"_{better}" if better[:1].isdecimal() else better
        yield finding(
            name,
            f"'{name}' is not a valid node name: the node does not start",
            advice=f"write '{better}'" if VALID.match(better) else "use letters, digits and underscores",
            fix=fix(f"write '{better}'", (name, better), safe=False)
            if VALID.match(better) and name.span.text == name
            else None,
        )


def _is_valid_where_included(robot: Robot, node: Started) -> bool:
    """Whether other launch files include the file of the node, and all of them make the name valid."""
    around = (each for each in robot.launch.leading_to(node.file) if each.entry is not node.file)
    names = [launch.literal_text(each.name) for other in around for each in other.nodes if each.action is node.action]
    return bool(names) and all(name is None or VALID.match(name) for name in names)
