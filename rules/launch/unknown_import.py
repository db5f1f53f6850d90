"""A launch file imports a name that launch does not have.

## What it finds
`from launch… import X` and `from launch_ros… import X` where no ROS distribution, or not the robot's distribution,
has X in that package. Reported only where exactly one existing name is close to X.

## Why it matters on a robot
The import fails, and with it the whole launch file: nothing starts.

## Bad
```python
from launch_ros.actions import LoadComposableNode
```

## Good
```python
from launch_ros.actions import LoadComposableNodes
```

## When to ignore it
When the robot runs a patched launch that has the name, or when the import is inside a `try` block for several
distributions.

## References
- launch and launch_ros, public names of each distribution
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule("error", fix="unsafe", symptoms=["ImportError: cannot import name"])
def unknown_import(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for imported in file.imports:
            known = launch.names_of(robot.launch, imported.module)
            if known is None or imported.name in known or imported.name == "*":
                continue
            if _may_be_module(imported.name):
                continue
            near = nearest(imported.name, known)
            if len(near) != 1:
                continue
            yield finding(
                imported.name,
                f"{imported.module} has no '{imported.name}': the import fails and nothing starts",
                advice=f"import {near[0]}",
                fix=fix(f"import {near[0]}", *((place, near[0]) for place in _uses(imported.name)), safe=False),
            )


def _uses(name: Located) -> Iterator[Span]:
    """Where a file uses a name that it imports, the import included; not as an attribute or in a quoted word."""
    source = name.span.source
    for match in re.finditer(rf"(?<![\w.'\"]){re.escape(name)}(?![\w'\"])", source.text):
        yield source.span(*match.span())


def _may_be_module(name: str) -> bool:
    """Whether a name has the form of a module: launch keeps each action in a module of its own."""
    return name.islower() and "_" in name
