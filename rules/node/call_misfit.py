"""A call whose arguments do not fit the function that it calls.

## What it finds
In Python nodes, and the Python programs and modules beside them, calls of functions and classes of the same file, or
of another file of the tree from which they are imported, of methods of the class itself, and of methods of an object
that is only ever of one class of the tree, that hand over too many arguments, too few, or one under a name that the
function does not have.
Functions that have decorators, several definitions or a subclass that defines them anew are left out, and so are
calls with `*` or `**`. It is an info in packages that others wrote and the tree only carries.

## Why it matters on a robot
Python looks at the arguments when the line runs. In the branch for an error, a goal or an emergency stop that may be
weeks later, on the robot. The TypeError then ends the node.

## Bad
```python
def stop(self):
    self.publisher.publish(Twist())

def on_bumper(self, message):
    self.stop(message)
```

## Good
```python
def on_bumper(self, message):
    self.stop()
```

## When to ignore it
When something replaces the function at run time.

## References
- https://docs.python.org/3/reference/expressions.html, "Calls"
"""

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
        "TypeError: *() takes * positional arguments but * were given",
        "TypeError: *() missing * required positional argument*",
        "TypeError: *() got an unexpected keyword argument '*'",
    ],
)
def call_misfit(robot: Robot) -> Iterator[Finding]:
    for found in nodes.unfit_calls(robot.nodes):
        where = f"in {found.function}()" if found.function is not None else "when the file is loaded"
        end = nodes.end_of(robot.nodes.syntax(found.file), found.call, caught=found.caught)
        started = found.function != "main" or robot.nodes.runs_main(found.file.source)
        idle = found.idle and robot.nodes.is_idle(found.file, found.function)
        idle = idle or not started or (found.function or "").startswith("test")
        taken = found.definition.args.args
        yield finding(
            found.file.span_of(found.call),
            f"TypeError {where}: {found.called}() {found.wrong}, and {end}",
            advice="hand over what the function takes",
            related=[note(found.defined.span_of(each), f"'{each.arg}'") for each in taken if each.arg != "self"],
            severity="info" if idle else robot.nodes.lowered_if_vendored(found.file.source, "error"),
        )
