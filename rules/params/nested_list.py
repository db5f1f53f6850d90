"""A parameter is a list inside a list.

## What it finds
Nested lists as parameter values. A single inner list is a warning, because rcl reads it as if the outer list did
not exist.

## Why it matters on a robot
rcl rejects the whole file: 'Sequences cannot be key'. Every node that loads it exits at start.

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

## When to ignore it
When the node parses the file itself and rcl never reads it.

## References
- rcl_yaml_param_parser, `parse_file_events`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import params
from bringup_lint.api import rule


@rule("error", symptoms=["Sequences cannot be key"])
def nested_list(robot: Robot) -> Iterator[Finding]:
    for file, problem in robot.params.problems("nested-list"):
        yield finding(
            problem.where,
            "rcl does not support nested lists: the process that loads the file exits at start",
            advice="write a flat list, or one quoted string that the node parses",
            severity=params.severity_of_refusal(robot.params, file),
        )
    for _, parameter in robot.params.parameters:
        if params.is_flattened(parameter):
            yield finding(
                parameter.span,
                f"rcl reads '{parameter.name}' as if its inner list were the whole list",
                advice="write a flat list",
                severity="warning",
            )
