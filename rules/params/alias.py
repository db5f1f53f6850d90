"""The parameter file uses a YAML alias.

## What it finds
`*name` and merge keys (`<<: *name`) in a file that rcl reads itself. Not reported: anchors without an alias, and
files that only PyYAML reads, because they are for composable nodes or rewritten by a launch helper.

## Why it matters on a robot
rcl rejects the whole file: 'Will not support aliasing'. Every node that loads it exits at start.

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

## When to ignore it
When only your own program, which resolves aliases, reads the file before ROS gets it.

## References
- rcl_yaml_param_parser, `parse_file_events`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import params
from bringup_lint.api import rule
from bringup_lint.api.params import ParameterFile


@rule("error", symptoms=["Will not support aliasing"])
def alias(robot: Robot) -> Iterator[Finding]:
    found: dict[ParameterFile, list[Located | Span]] = {}
    for file, problem in robot.params.problems("alias"):
        if robot.params.read_by(file) != "pyyaml":
            found.setdefault(file, []).append(problem.where)
    for file, (first, *others) in found.items():
        yield finding(
            first,
            "rcl does not support YAML aliases: the process that loads the file exits at start",
            advice="write the values out, or use a block for '/**'",
            related=[note(other, "another alias") for other in others[:20]],
            severity=params.severity_of_refusal(robot.params, file),
        )
