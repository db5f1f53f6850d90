"""A local name is used before it has a value.

## What it finds
In the functions of Python nodes, and of the Python modules beside them, a name that the function assigns only further
down, as when `global` is missing for one of the file; a name that a `try` alone assigns, whose `except` only prints
or logs, and that is used right after it, in a loop too, where the first turn may fail; and one that an `if` without
`else` alone assigns, and that is used after it in any case, with `elif` where the file handles other values elsewhere,
unless the branches are for x86_64 and aarch64, the two that ROS 2 has packages for, ask for nothing else, and the file
knows no third one. Other loops, where a turn before may have set it, are left out, and so is what runs only under a
condition. It is an info in packages that others wrote and the tree only carries.

## Why it matters on a robot
An assignment anywhere in a function makes the name local to all of it. Python finds out when the line runs: on the
robot, in the callback for the first message, or on the day on which the device is not there. The UnboundLocalError then
ends the node, and the log no longer shows what really failed.

## Bad
```python
try:
    pose = self.buffer.lookup_transform('map', 'base_link', Time())
except TransformException as error:
    self.get_logger().warning(str(error))
self.publisher.publish(pose)
```

## Good
```python
except TransformException as error:
    self.get_logger().warning(str(error))
    return
```

## When to ignore it
When the call in the `try` can never fail.

## References
- https://docs.python.org/3/faq/programming.html, "Why am I getting an UnboundLocalError when the variable has a value?"
"""

import ast
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "UnboundLocalError: cannot access local variable '*' where it is not associated with a value",
        "UnboundLocalError: local variable '*' referenced before assignment",
    ],
)
def unbound_local(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_code:
        for found in nodes.unbound_locals(robot.nodes.syntax(file)):
            name, severity = found.name.id, "error"
            idle = found.idle and robot.nodes.is_idle(file, found.function)
            end = nodes.end_of(robot.nodes.syntax(file), found.name, caught=found.caught)
            message = f"UnboundLocalError in {found.function}(): {name} is assigned there, thus local, and unset: {end}"
            advice = f"assign {name} before it is used"
            related = [note(file.span_of(found.bound_at), "makes it local to the function")]
            if found.is_global:
                advice = f"write 'global {name}' at the start of {found.function}()"
            if isinstance(found.without, ast.If):
                severity = "warning"
                unmet = "none of the conditions holds" if found.without.orelse else "the condition does not hold"
                message = f"UnboundLocalError in {found.function}(): {name} has no value when {unmet}: {end}"
                advice = f"use {name} under the same condition, or give it a value before"
                related = [note(file.span_of(found.without.test), "only under this condition does it get a value")]
            elif found.without is not None:
                severity = "warning"
                message = f"UnboundLocalError in {found.function}(): {name} has no value after the exception: {end}"
                advice = f"return in the handler, or give {name} a value there"
                related = [
                    note(file.span_of(found.bound_at), "only here does it get a value"),
                    note(file.span_of(found.without.type or found.without.body[0]), "goes on without it"),
                ]
            yield finding(
                file.span_of(found.name),
                message,
                advice=advice,
                related=related,
                severity="info" if idle else robot.nodes.lowered_if_vendored(file.source, severity),
            )
