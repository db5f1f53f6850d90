"""`ros__parameters` stands at the root, without a node name.

## What it finds
A parameter file whose outermost key is `ros__parameters`.

## Why it matters on a robot
rcl refuses the file: 'There are no node names before ros__parameters'. Every node that gets it exits at start.

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

## References
- rcl_yaml_param_parser, `parse_key`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["There are no node names before ros__parameters"])
def root_ros_parameters(robot: Robot) -> Iterator[Finding]:
    for _, problem in robot.params.problems("no-node-name"):
        yield finding(
            problem.where,
            "No node name stands above ros__parameters: the process that loads the file exits at start",
            advice="put the node name, or '/**' for every node, above it and indent the rest",
        )
