"""A parameter is a list of mappings.

## What it finds
Mappings inside the list of a parameter. An error where rcl rejects the file because of it.

## Why it matters on a robot
rcl has no such type. It makes one wrong parameter of the first mapping's keys, or rejects the whole file. The node
never sees the list.

## Bad
```yaml
planner:
  ros__parameters:
    goals: [{x: 1.0}, {x: 2.0}]
```

## Good
```yaml
planner:
  ros__parameters:
    goals: [dock, gate]
    dock: {x: 1.0}
    gate: {x: 2.0}
```

## When to ignore it
When the node does not read the list through ROS parameters but parses the file itself.

## References
- rcl_yaml_param_parser, `parse_file_events`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import params
from bringup_lint.api import rule

_ADVICE = "write a list of names, and one mapping for each name"


@rule("warning", symptoms=["Sequence should be of same type"])
def list_of_maps(robot: Robot) -> Iterator[Finding]:
    refused = set()
    for file, problem in robot.params.problems("list-of-maps"):
        refused.add(problem.where)
        yield finding(
            problem.where,
            "rcl does not support lists of mappings: the process that loads the file exits at start",
            advice=_ADVICE,
            severity=params.severity_of_refusal(robot.params, file) or "error",
        )
    for _, parameter in robot.params.parameters:
        if parameter.span not in refused and params.holds_maps(parameter):
            yield finding(
                parameter.span,
                f"rcl does not read '{parameter.name}' as a list: it mixes up the values of the mappings",
                advice=_ADVICE,
            )
