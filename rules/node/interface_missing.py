"""A node imports a message, service or action that its package does not have.

## What it finds
`from PACKAGE.msg import NAME` at the top of Python nodes, and the same with `srv` and `action`, where PACKAGE is in the
tree, is declared in package.xml, and defines no such interface, or has the file and does not list it in
`rosidl_generate_interfaces`. Imports inside of `try` or a function are left alone, and packages whose interfaces come
from elsewhere.

## Why it matters on a robot
The import raises ImportError: the node ends at its start, and so does every restart. The build does not see it.

## Bad
```python
from farm_msgs.msg import HopperStates   # farm_msgs/msg/HopperState.msg
```

## Good
```python
from farm_msgs.msg import HopperState
```

## When to ignore it
When the robot has another version of the package than the tree.

## References
- rosidl, rosidl_generator_py
- https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Custom-ROS2-Interfaces.html
"""

import os
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule("error", fix="unsafe", symptoms=["ImportError: cannot import name '*' from '*.msg'"])
def interface_missing(robot: Robot) -> Iterator[Finding]:
    for each in robot.dependencies.missing_interfaces:
        source = each.name.span.source
        if robot.launch.workspace.is_vendored(source):
            continue
        near = nearest(str(each.name), each.known, 1) if each.file is None else []
        yield finding(
            each.name,
            f"{each.owner.name} {_lack(each.kind, each.name, each.file)}: the import fails, and the node ends",
            advice=_advice(near, each.file),
            related=[note(each.owner.place, f"the package {each.owner.name}")],
            fix=fix(f"import {near[0]}", (each.name, near[0]), safe=False) if len(near) == 1 else None,
            severity=robot.nodes.lowered(source, "error"),
        )


def _lack(kind: str, name: str, file: str | None) -> str:
    return f"does not generate {os.path.basename(file)}" if file else f"has no {kind} '{name}'"


def _advice(near: list[str], file: str | None) -> str:
    if file:
        return "add the file to rosidl_generate_interfaces"
    if near:
        return f"import {near[0]} if its fields are those that the node uses, else define the one that is missing"
    return "define it, or import what the package has"
