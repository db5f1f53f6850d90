"""A parameter is an empty list or mapping.

## What it finds
`[]` and `{}` as values, as a warning. An error for an empty mapping before other parameters: for rcl it ends the
block or swallows the names that follow. Info when no source of the nodes names the parameter, by the launch files that
load it, or because the sources of the tree name nearly all others of the block.

## Why it matters on a robot
An empty list has no type. The parameter counts as set without a value, and a node that declares it with a type
exits with an exception.

## Bad
```yaml
planner:
  ros__parameters:
    plugins: []
```

## Good
```yaml
planner:
  ros__parameters:
    plugins: [""]
```

## When to ignore it
When the node declares the parameter with dynamic typing and treats an unset value as an empty list.

## References
- rclcpp, `parameter_value_from`
- rclpy, `Node.declare_parameter`: "Cannot declare a statically typed parameter with default value of type
  PARAMETER_NOT_SET"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import params
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=["No parameter value set", "statically typed parameter with default value of type PARAMETER_NOT_SET"],
)
def empty_list(robot: Robot) -> Iterator[Finding]:
    ended = set()
    for file, problem in robot.params.problems("after-empty-map"):
        if robot.params.read_by(file) != "pyyaml":
            ended.add(problem.where)
            yield finding(
                problem.where,
                "For rcl the empty mapping ends the block: it reads the next parameter as a node, and the process that "
                "loads the file exits at start",
                advice="remove the empty mapping",
                severity=params.severity_of_refusal(robot.params, file) or "error",
            )
    for _, parameter in robot.params.parameters:
        if parameter.text in ("[]", "{}", "[ ]", "{ }") and parameter.span not in ended:
            kind = "list" if parameter.text.startswith("[") else "mapping"
            yield finding(
                parameter.span,
                f"'{parameter.name}' is an empty {kind} without a type: a node that declares it with a type exits "
                "with an exception",
                advice="remove the line, or write a list with one value of the type"
                if kind == "list"
                else "remove the line",
                severity="info" if params.is_never_read(robot.params, parameter) else None,
            )
