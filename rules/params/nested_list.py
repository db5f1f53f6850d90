"""A list stands inside a list.

## What it finds
Nested lists as parameter values; a warning for a single inner list, which rcl reads as if the outer one were not there.

## Why it matters on a robot
rcl refuses the whole file: 'Sequences cannot be key'. Every node that gets it exits at start.

## Bad
```yaml
planner:
  ros__parameters:
    footprint: [[0.1, 0.1], [0.1, -0.1]]
```

## Good
```yaml
planner:
  ros__parameters:
    footprint: "[[0.1, 0.1], [0.1, -0.1]]"
```

## References
- rcl_yaml_param_parser, `parse_file_events`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Sequences cannot be key"])
def nested_list(robot: Robot) -> Iterator[Finding]:
    for _, problem in robot.params.problems("nested-list"):
        yield finding(
            problem.where,
            "rcl knows no nested lists: the process that loads the file exits at start",
            advice="write a flat list, or one text in quotes that the node takes apart",
        )
    for _, parameter in robot.params.parameters:
        if robot.params.is_flattened(parameter):
            yield finding(
                parameter.span,
                f"rcl reads '{parameter.name}' as if its inner list were the whole list",
                advice="write a flat list",
                severity="warning",
            )
