"""A parameter has no value.

## What it finds
A key with nothing after the colon, in a file that rcl reads itself. An empty string in quotes is a value.

## Why it matters on a robot
rcl rejects the whole file: 'No value at line 3'. Every node that loads it exits at start.

## Bad
```yaml
motors:
  ros__parameters:
    port:
```

## Good
```yaml
motors:
  ros__parameters:
    port: ""
```

## When to ignore it
When a script fills in the value before a node loads the file.

## References
- rcl_yaml_param_parser, `parse_value`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import params
from bringup_lint.api import rule


@rule("error", symptoms=["No value at line", "Couldn't parse params file"])
def empty_value(robot: Robot) -> Iterator[Finding]:
    for file, problem in robot.params.problems("no-value"):
        if robot.params.read_by(file) == "pyyaml":
            continue
        parameter = robot.params.at(file, problem.where)
        name = f"'{parameter.name}' has no value" if parameter else "There is no value here"
        yield finding(
            parameter.key if parameter else problem.where,
            f"{name}: the process that loads the file exits at start",
            advice='give it a value (an empty string is ""), or remove the line',
            severity=params.severity_of_refusal(robot.params, file),
        )
