"""A parameter is declared with an empty list, and so as a byte array.

## What it finds
`declare_parameter('x', [])` in Python nodes.

## Why it matters on a robot
rclpy takes the type from the default, and an empty list has none: it becomes a BYTE_ARRAY. Whatever list of texts or
numbers a parameter file, a launch file or `ros2 param set` gives, is refused: the node ends at its start with
InvalidParameterTypeException. Only the robot that nobody configures works.

## Bad
```python
self.declare_parameter('addresses', [])
```

## Good
```python
self.declare_parameter('addresses', [''])
```

## When to ignore it
When the parameter is a list of bytes, or nobody is to set it.

## References
- rclpy, parameter.py, Parameter.Type.from_parameter_value
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["of type 'STRING_ARRAY', expecting type 'BYTE_ARRAY'", "InvalidParameterTypeException"])
def empty_list_default(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        found = list(nodes.empty_defaults(robot.nodes.syntax(file)))
        for name, default in found[:1]:
            yield finding(
                file.span_of(default),
                f"'{name}' becomes a byte array: the node exits when a file or launch file gives it a list",
                advice="write a default with one value of its type, such as [''] or [0.0]",
                related=[note(file.span_of(each.default), f"'{each.name}' as well") for each in found[1:]],
                severity=robot.nodes.lowered(file.source, "warning"),
            )
