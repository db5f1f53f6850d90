"""A value is outside `ros__parameters`.

## What it finds
Values between a node name and `ros__parameters` or next to it. Misspellings such as `ros_parameters` and
`ros__parameter`. Files without any `ros__parameters` that a launch file passes to a node. A file that no launch
file of this tree loads is checked only in a folder for configuration, and is a warning.

An error where a launch file of the tree gives the file to a node, info where the tree has launch files and nothing
names the file, else a warning. A page names it where it has people give it to a node, not to `ros2 launch`, which takes
no such option.

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
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import params
from bringup_lint.api import rule
from bringup_lint.api.params import ParameterFile

_FOLDERS = ("config", "cfg", "conf", "param", "params")


@rule("error", fix="safe", symptoms=["Cannot have a value before ros__parameters", "Couldn't parse params file"])
def missing_ros_parameters(robot: Robot) -> Iterator[Finding]:
    misspelt: dict[ParameterFile, list[Located | Span]] = {}
    for file, problem in robot.params.problems("misspelt-header"):
        if (
            robot.params.read_by(file)
            or any(not block.name.startswith("ros_") for block in file.blocks)
            or in_config(file)
        ):
            misspelt.setdefault(file, []).append(problem.where)
    for file, (first, *others) in misspelt.items():
        yield finding(
            first,
            f"'{first}' is not ros__parameters: {_effect(robot, file, 'the file')}",
            advice="write ros__parameters, with two underscores",
            related=[note(other, "here too") for other in others],
            fix=fix(
                "write ros__parameters",
                *((where, "ros__parameters") for where in (first, *others)),
                safe=robot.params.read_by(file) == "rcl" and "ros__parameters:" not in file.source.text,
            ),
            severity=params.severity_of_refusal(robot.params, file),
        )
    outside: dict[ParameterFile, list[Located | Span]] = {}
    for file, problem in robot.params.problems("value-before-parameters", "list-before-parameters", "internal"):
        if robot.params.read_by(file) == "rcl" or (not robot.params.read_by(file) and in_config(file)):
            outside.setdefault(file, []).append(problem.where)
    for file, (first, *others) in outside.items():
        yield _outside(robot, file, first, others if file.is_certain else [])


def _outside(robot: Robot, file: ParameterFile, first: Located | Span, others: list[Located | Span]) -> Finding:
    """rcl stops at the first value that is outside; the others are named with it."""
    loads = [note(load.where, "a node loads it here") for load in robot.params.loads(file)[:1]]
    if file.is_certain:
        message = f"A value is outside ros__parameters: rcl refuses this file, {_effect(robot, file, 'it')}"
    else:
        message = f"The file has no ros__parameters: {_effect(robot, file, 'it')}"
    return finding(
        first,
        message,
        advice="move it below ros__parameters"
        if file.is_certain
        else "put the node name and ros__parameters above the values",
        related=[*loads, *(note(other, "outside, too") for other in others[:20])],
        severity=params.severity_of_refusal(robot.params, file),
    )


def _effect(robot: Robot, file: ParameterFile, name: str) -> str:
    """What follows: rcl ends the process; launch, which reads the files of components itself, finds no values."""
    if robot.params.read_by(file) == "pyyaml":
        return f"the components that get {name} keep their defaults"
    return f"the process that loads {name} exits at start"


def in_config(file: ParameterFile) -> bool:
    return any(folder in _FOLDERS for folder in file.source.name.split("/")[:-1])
