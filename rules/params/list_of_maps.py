"""A list holds mappings.

## What it finds
Mappings inside the list of a parameter; an error where rcl refuses the file for it.

## Why it matters on a robot
rcl knows no such value. It makes one odd parameter of the first mapping's keys, or refuses the whole file, and the node
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

## References
- rcl_yaml_param_parser, `parse_file_events`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

_ADVICE = "write a list of names and one mapping for each of them"


@rule("warning", symptoms=["Sequence should be of same type"])
def list_of_maps(robot: Robot) -> Iterator[Finding]:
    refused = set()
    for file, problem in robot.params.problems("list-of-maps"):
        refused.add(problem.where)
        yield finding(
            problem.where,
            "rcl knows no list of mappings: the process that loads the file exits at start",
            advice=_ADVICE,
            severity="warning" if robot.params.reader(file) == "pyyaml" else "error",
        )
    for _, parameter in robot.params.parameters:
        if parameter.span not in refused and robot.params.holds_maps(parameter):
            yield finding(
                parameter.span,
                f"rcl does not read '{parameter.name}' as a list: the values of its mappings are mixed up",
                advice=_ADVICE,
            )
