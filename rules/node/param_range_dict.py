"""A parameter range is a dictionary instead of a message.

## What it finds
`floating_point_range=[{...}]` or `integer_range=[{...}]` in a `ParameterDescriptor`.

## Why it matters on a robot
The descriptor accepts the dictionary, but `declare_parameter` raises "'dict' object has no attribute 'from_value'".
The node exits while it starts.

## Bad
```python
ParameterDescriptor(floating_point_range=[{'from_value': 0.0, 'to_value': 1.5, 'step': 0.1}])
```

## Good
```python
ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.5, step=0.1)])
```

## When to ignore it
Never: `declare_parameter` accepts only the messages.

## References
- tried with rclpy 7.1 (Jazzy)
- rcl_interfaces/msg/FloatingPointRange, rcl_interfaces/msg/IntegerRange
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["AttributeError: 'dict' object has no attribute 'from_value'"])
def param_range_dict(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_sources:
        syntax = robot.nodes.syntax(file)
        for found in nodes.dict_ranges(syntax):
            place, better = file.span_of(found.place), nodes.range_text(syntax, found)
            change = None
            if better is not None:
                edits = nodes.import_edits(file, "rcl_interfaces.msg", found.type)
                change = fix(f"write {found.type}", (place, better), *edits)
            yield finding(
                place,
                f"The range is a dict, not {found.type}: declare_parameter raises AttributeError, "
                "and the node does not start",
                advice=f"write {better or f'{found.type}(from_value=..., to_value=..., step=...)'}",
                fix=change,
                severity=robot.nodes.lowered(file.source, "error"),
            )
