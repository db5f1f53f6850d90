"""A value is outside `ros__parameters`.

## What it finds
Values between a node name and `ros__parameters` or next to it. Misspellings such as `ros_parameters` and
`ros__parameter`. Files without any `ros__parameters` that a launch file passes to a node. A file that no launch
file of this tree loads is checked only in a folder for configuration, and is a warning.

## Why it matters on a robot
rcl rejects the whole file: 'Cannot have a value before ros__parameters'. Every node that loads it exits at start.

## Bad
```yaml
motors:
  ros_parameters:
    rate: 50
```

## Good
```yaml
motors:
  ros__parameters:
    rate: 50
```

## When to ignore it
When the file is not a ROS parameter file, for example the configuration of a library that is only stored in the
same folder.

## References
- rcl_yaml_param_parser, `parse_file_events`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import ParameterFile

_FOLDERS = ("config", "cfg", "conf", "param", "params")


@rule("error", fix="safe", symptoms=["Cannot have a value before ros__parameters", "Couldn't parse params file"])
def missing_ros_parameters(robot: Robot) -> Iterator[Finding]:
    for file, problem in robot.params.problems("misspelt-header"):
        if (
            robot.params.reader(file)
            or any(not block.name.startswith("ros_") for block in file.blocks)
            or in_config(file)
        ):
            yield finding(
                problem.where,
                f"'{problem.where}' is not ros__parameters: the process that loads the file exits at start",
                advice="write ros__parameters, with two underscores",
                fix=fix("write ros__parameters", (problem.where, "ros__parameters")),
            )
    plain = set()
    for file, problem in robot.params.problems("value-before-parameters", "list-before-parameters", "internal"):
        known = robot.params.reader(file) == "rcl"
        if not (known or in_config(file)) or file.source in plain:
            continue
        if not file.is_certain:
            plain.add(file.source)
        yield finding(
            problem.where,
            "The file has no ros__parameters: the process that loads it exits at start"
            if not file.is_certain
            else "A value is outside ros__parameters: the process that loads the file exits at start",
            advice="put the node name and ros__parameters above the values"
            if not file.is_certain
            else "move it below ros__parameters",
            related=[note(load.where, "a node loads it here") for load in robot.params.loads(file)[:1]],
            severity=None if known else "warning",
        )


def in_config(file: ParameterFile) -> bool:
    return any(folder in _FOLDERS for folder in file.source.name.split("/")[:-1])
