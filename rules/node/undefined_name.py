"""A name is used that nothing imports or defines.

## What it finds
Names that the source of a node, or a Python module beside it, looks up and that neither the function, the file nor
Python defines: a message type or `sys` that is never imported, a variable of another function, a method that is called
without `self.`, a misspelt name, or `xrange` and the like, which only Python 2 has.

It is an info in tests, in examples and in a function that nothing calls or that is only a stub. It is a warning after
`spin()` and the `join()` of a thread, where the node has done its work, in an `except`, which runs only after a
failure, and in a branch of a function. It is an info in packages that others wrote and the tree only carries.

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


@rule("error", fix="unsafe", symptoms=["NameError: name '*' is not defined"])
def undefined_name(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_code:
        for found in nodes.undefined_in(robot.nodes, file):
            name, module = found.name.id, found.module
            when = f"when {found.function}() is called" if found.function else "when the file is loaded"
            when = f"in a branch of {found.function}()" if found.branch and not found.handling else when
            when = f"{when} and its try block has failed" if found.handling else when
            end = nodes.end_of(robot.nodes.syntax(file), found.name, caught=found.caught)
            end = "the node ends with this traceback" if found.late else end
            line = f"from {module} import {name}" if module else f"import {name}"
            started = found.function != "main" or robot.nodes.runs_main(file.source)
            rare = found.late or found.handling or found.branch
            severity = "info" if not started else "warning" if rare else "error"
            where = found.function or "the file"
            idle = found.idle and robot.nodes.is_idle(file, found.function)
            edits = nodes.import_edits(file, module, name) if module is not None else []
            yield finding(
                file.span_of(found.name),
                f"NameError {when}: {name} is never {'defined' if module is None else 'imported'}, and {end}",
                advice=f"add '{line}'" if module is not None else f"define {name} where {where} sees it",
                fix=fix(f"add '{line}'", *edits) if edits else None,
                severity="info" if idle else robot.nodes.lowered_if_vendored(file.source, severity),
            )
