"""A node name is not valid.

## What it finds
Literal node names that are empty, start with a digit, contain characters other than letters, digits and
underscores, or are longer than 255 characters.

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

VALID = regex(r"[A-Za-z_][A-Za-z0-9_]{0,254}\Z")


@rule("error", fix="unsafe", symptoms=["node name must not contain characters other than alphanumerics or '_'"])
def node_name_invalid(robot: Robot) -> Iterator[Finding]:
    for node in robot.launch.nodes:
        name = launch.literal_text(node.name)
        if name is None or VALID.match(name) or not node.is_node:
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
