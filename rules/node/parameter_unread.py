"""A parameter is set, declared and never read.

## What it finds
`declare_parameter('x', ...)` in a Python node whose result nobody uses, when `x` appears nowhere else in the program,
and a parameter file that a launch file gives to the node sets it. Programs that read parameters by computed names, or
hear of changes, are left out. In C++, a `declare_parameter("x", ...)` whose result nobody uses, when no source of the
package names `x` again, and a launch or parameter file of the package sets it.

A value that is read into a variable or attribute which nothing of the package uses, except to log it, is found as well:
as information where no launch or parameter file of the package sets the parameter. It is an info, too, where a page of
the package, or a comment beside the parameter, says of it without a condition that it is not used.

A C++ node that only compares the name in the callback for changes is found as well, whoever sets the parameter, when it
registers that callback after the declaration: the callback is told of later changes, not of the first value.

## Why it matters on a robot
`ros2 param get` shows the value of the file, and the node works with a number of its own. Whoever lowers a speed or a
timeout there changes nothing.

## Bad
```python
self.declare_parameter('max_speed', 1.0)
self.limit = 1.0
```

## Good
```python
self.limit = self.declare_parameter('max_speed', 1.0).value
```

## When to ignore it
When another program reads the parameter of this node, through its parameter services.

## References
- https://docs.ros.org/en/jazzy/Concepts/Basic/About-Parameters.html
"""

from collections.abc import Iterator
from functools import partial

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", silent="the parameter has the value that the file gives")
def parameter_unread(robot: Robot) -> Iterator[Finding]:
    for found in nodes.unread_parameters(robot.nodes, robot.params):
        yield finding(
            found.name,
            f"The node never reads '{found.name}': what the parameter file sets has no effect",
            advice=f"use get_parameter('{found.name}').value, or remove the parameter",
            related=[note(each.span, "set here") for each in found.given[:5]],
            severity=_severity(robot, found.file.source, found.name),
        )
    for unread in nodes.unread_in_cpp(robot.nodes):
        yield finding(
            unread.parameter.name,
            f"No source of the package reads '{unread.parameter.name}': what is set has no effect",
            advice=f'use get_parameter("{unread.parameter.name}"), or remove the parameter',
            related=[note(unread.given, "set here")],
            severity=_severity(robot, unread.source, unread.parameter.name),
        )
    for source, parameter in nodes.heard_parameters(robot.nodes):
        yield finding(
            parameter.name,
            f"The node hears of changes of '{parameter.name}', and never reads the value that it starts with: what a "
            "file or launch sets has no effect",
            advice="register the callback before the declaration, or call get_parameter() once",
            severity=robot.nodes.lowered(source.source, "warning"),
        )
    yield from map(partial(_unused, robot), nodes.unused_in_cpp(robot.nodes))
    yield from map(partial(_unused, robot), nodes.unused_in_python(robot.nodes))


def _unused(robot: Robot, unused: nodes.UnusedParameter) -> Finding:
    """A value that goes to a variable, and no further."""
    uses = "nothing but a log line" if unused.is_logged else "nothing"
    return finding(
        unused.name,
        f"The value of '{unused.name}' is kept in {unused.variable}, which {uses} uses: what is set has no effect",
        advice=f"use {unused.variable} where the node has a value of its own instead, or remove the parameter",
        related=[note(unused.given, "set here")] if unused.given is not None else [],
        severity=_severity(robot, unused.source, unused.name) if unused.given is not None else "info",
    )


def _severity(robot: Robot, source: Source, name: Located) -> str:
    return "info" if nodes.is_known_unread(robot.nodes, source, name) else robot.nodes.lowered(source, "warning")
