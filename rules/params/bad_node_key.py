"""A node key is not a node name.

## What it finds
Node keys with `-`, spaces, `~`, a leading digit, a trailing or repeated slash, a wildcard for only a part of a name
(`cam*`), or `*` without quotes. `/**`, `"*"` and `/*/name` are valid.

An error where a launch file of the tree gives the file to a node, info where the tree has launch files and nothing
names the file, else a warning.

## Why it matters on a robot
rcl checks the name and rejects the whole file. Every node that loads it exits at start.

## Bad
```yaml
motor-driver:
  ros__parameters:
    rate: 50
```

## Good
```yaml
motor_driver:
  ros__parameters:
    rate: 50
```

## When to ignore it
When a script rewrites the key before a node loads the file.

## References
- rcl_yaml_param_parser, `_validate_name`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import params
from bringup_lint.api import rule


@rule(
    "error",
    fix="safe",
    symptoms=[
        "node name must not contain characters other than alphanumerics or '_'",
        "node name must not start with a number",
        "contains repeated forward slash",
    ],
)
def bad_node_key(robot: Robot) -> Iterator[Finding]:
    for file, problem in robot.params.problems("unquoted-star"):
        yield finding(
            problem.where,
            f"{problem.where} without quotes is a YAML alias: the process that loads the file exits at start",
            advice=f'write "{problem.where}"',
            fix=fix("put it in quotes", (problem.where, f'"{problem.where}"')),
            severity=params.severity_of_refusal(robot.params, file),
        )
    for file, problem in robot.params.problems("node-key"):
        key = problem.where
        if robot.params.read_by(file) == "pyyaml" or any(sign in key for sign in "$<>{}%@"):
            continue
        name = next((block.name for block in file.blocks if block.key is key), key)
        yield finding(
            key,
            f"'{name}' is not a node name ({problem.detail}): the process that loads the file exits at start",
            advice="use letters, digits and _, and wildcards only for whole names",
            severity=params.severity_of_refusal(robot.params, file),
        )
