"""A ROS name is used but never imported.

## What it finds
Names such as `SetParametersResult`, `QoSProfile`, `ReliabilityPolicy` or `asyncio` that the source of a node uses,
but that nothing in the file imports or defines.

## Why it matters on a robot
Python looks a name up when the line runs. In a callback for parameters or signals that can be weeks later, on the
robot. The NameError then ends the node.

## Bad
```python
def on_change(self, parameters):
    return SetParametersResult(successful=True)
```

## Good
```python
from rcl_interfaces.msg import SetParametersResult
```

## When to ignore it
When the name is defined at run time, for example through `globals()` or a plug-in mechanism.

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


@rule("error", fix="unsafe", symptoms=["NameError: name 'SetParametersResult' is not defined"])
def undefined_name(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.programs:
        for name, module, function, stub in nodes.undefined(robot.nodes.syntax(file)):
            when = f"when {function}() is called" if function else "when the file is loaded"
            line = f"from {module} import {name.id}" if module else f"import {name.id}"
            yield finding(
                file.span_of(name),
                f"NameError {when}: {name.id} is never imported, and the node exits",
                advice=f"add '{line}'",
                fix=fix(f"add '{line}'", *nodes.import_edits(file, module, name.id)),
                severity="info" if stub else nodes.lowered(robot.nodes.purpose(file.source), "error"),
            )
