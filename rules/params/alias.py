"""The parameter file uses a YAML alias.

## What it finds
`*name` and merge keys (`<<: *name`) in a file that rcl reads itself. Anchors without an alias pass, and so do files
that only PyYAML reads: for composable nodes, or rewritten by a launch helper.

## Why it matters on a robot
rcl refuses the whole file: 'Will not support aliasing'. Every node that gets it exits at start.

## Bad
```yaml
left:
  ros__parameters: &wheel
    rate: 50
right:
  ros__parameters: *wheel
```

## Good
```yaml
left:
  ros__parameters:
    rate: 50
right:
  ros__parameters:
    rate: 50
```

## References
- rcl_yaml_param_parser, `parse_file_events`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Will not support aliasing"])
def alias(robot: Robot) -> Iterator[Finding]:
    for file, problem in robot.params.problems("alias"):
        if robot.params.reader(file) != "pyyaml":
            yield finding(
                problem.where,
                "rcl knows no YAML aliases: the process that loads the file exits at start",
                advice="write the values out, or use a block for '/**'",
            )
