"""A callback for new values of parameters reads the old ones.

## What it finds
A method handed to `add_on_set_parameters_callback` that never looks at the list of parameters that it is handed, and
asks the node with `get_parameter()` in its place.

## Why it matters on a robot
rclpy asks these callbacks whether the new values may be set, before it sets them. `get_parameter()` still gives the
old value there. `ros2 param set` answers "Set parameter successful", the node goes on with the value of before, and
takes each value one change too late; a value that the callback means to refuse is never refused.

## Bad
```python
def on_parameters(self, parameters):
    self.limit = self.get_parameter("limit").value
    return SetParametersResult(successful=True)
```

## Good
```python
def on_parameters(self, parameters):
    for parameter in parameters:
        if parameter.name == "limit":
            self.limit = parameter.value
    return SetParametersResult(successful=True)
```

## When to ignore it
When the callback only reads parameters that nothing changes while the node runs.

## References
- rclpy, node.py, `_set_parameters_atomically_common`: callbacks first, then the values
- https://docs.ros.org/en/jazzy/Concepts/Basic/About-Parameters.html, "Parameter callbacks"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the answer is 'Set parameter successful', and the node goes on with the old value")
def parameter_callback_stale(robot: Robot) -> Iterator[Finding]:
    for stale in nodes.stale_reads(robot.nodes):
        yield finding(
            stale.file.span_of(stale.read),
            f"{stale.function}() runs before the new values are set: this reads the old one, and each change takes "
            "effect one change too late",
            advice=f"read the values from the list that {stale.function}() is handed",
            related=[note(stale.callback.span, "handed over here")],
            severity=robot.nodes.lowered(stale.file.source, "warning"),
        )
