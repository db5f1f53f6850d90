"""A name of ROS is used and never imported.

## What it finds
Names such as `SetParametersResult`, `QoSProfile`, `ReliabilityPolicy` or `asyncio` that a node source uses and that
nothing in the file imports or defines.

## Why it matters on a robot
Python looks names up when the line runs. In a callback for parameters or for a signal that is weeks later, on the
robot, and the NameError then ends the node.

## Bad
```python
def on_change(self, parameters):
    return SetParametersResult(successful=True)
```

## Good
```python
from rcl_interfaces.msg import SetParametersResult
```

## References
- https://docs.python.org/3/reference/executionmodel.html, "Resolution of names"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["NameError: name 'SetParametersResult' is not defined"])
def undefined_name(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.programs:
        for name, module, function in nodes.undefined(robot.nodes.syntax(file)):
            when = f"when {function}() is called" if function else "when the file is loaded"
            line = f"from {module} import {name.id}" if module else f"import {name.id}"
            yield finding(
                file.span_of(name),
                f"NameError {when}: {name.id} is never imported, and the node ends",
                advice=f"add '{line}'",
                fix=fix(f"add '{line}'", *nodes.import_edits(file, module, name.id)),
                severity=nodes.lowered(robot.nodes.purpose(file.source), "error"),
            )
