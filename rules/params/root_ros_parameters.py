"""`ros__parameters` is at the root, without a node name.

## What it finds
A parameter file whose outermost key is `ros__parameters`.

An error where a launch file of the tree gives the file to a node, info where the tree has launch files and nothing
names the file, else a warning.

## Why it matters on a robot
rcl rejects the file: 'There are no node names before ros__parameters'. Every node that loads it exits at start.

## Bad
```yaml
ros__parameters:
  rate: 50
```

## Good
```yaml
/**:
  ros__parameters:
    rate: 50
```

## When to ignore it
When a script puts the node name above the block before a node loads the file.

## References
- rcl_yaml_param_parser, `parse_key`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import params
from bringup_lint.api import rule


@rule("error", symptoms=["There are no node names before ros__parameters"])
def root_ros_parameters(robot: Robot) -> Iterator[Finding]:
    for file, problem in robot.params.problems("no-node-name"):
        yield finding(
            problem.where,
            "There is no node name above ros__parameters: the process that loads the file exits at start",
            advice="put the node name, or '/**' for every node, above it and indent the rest",
            severity=params.severity_of_refusal(robot.params, file),
        )
