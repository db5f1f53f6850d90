"""A launch configuration is read but never declared.

## What it finds
`LaunchConfiguration('x')` or `$(var x)` without a default, where neither the file nor a file that includes it
declares or sets `x`. A certain read in a Python file is an error, other reads are warnings. If the file reads more
than two such names, or another launch file mentions it, it is probably part of a larger launch file, and the
finding is info.

## Why it matters on a robot
launch stops with "launch configuration 'x' does not exist" unless somebody passes `x:=…` by hand. A unit that
starts the file without it fails at every boot.

## Bad
```python
LaunchDescription([
    Node(package='demo', executable='talker', namespace=LaunchConfiguration('robot_name')),
])
```

## Good
```python
LaunchDescription([
    DeclareLaunchArgument('robot_name', default_value='robot'),
    Node(package='demo', executable='talker', namespace=LaunchConfiguration('robot_name')),
])
```

## When to ignore it
When the file is only ever included, by a launch file outside this tree that sets the configuration.

## References
- launch, `LaunchConfiguration.perform`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import Expansion
from bringup_lint.api.launch import Used
from bringup_lint.api.spelling import nearest

OWN = ("ros_namespace", "ros_remaps", "global_params")
"""launch_ros keeps these among the launch configurations."""


@rule("error", symptoms=["launch configuration 'robot_name' does not exist"])
def undeclared_arg(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        declared = {each.name: each for each in expansion.declared}
        missing = {str(used.argument.name) for used in expansion.unbound} - declared.keys()
        for used in expansion.unbound:
            name = str(used.argument.name)
            if not used.certain or name not in missing or name in OWN:
                continue
            near = nearest(name, declared)
            related = [note(span, "included from here") for span in used.chain]
            related += [note(declared[other].action.span, f"'{other}' is declared here") for other in near]
            yield finding(
                used.argument.name,
                f"launch configuration '{name}' is not declared: launch aborts unless {name}:= is passed",
                advice=f"declare '{name}'" + (f", or read '{near[0]}'" if near else ""),
                severity=None if near else grade(robot, expansion, used, missing),
                related=related,
            )


def grade(robot: Robot, expansion: Expansion, used: Used, missing: set[str]) -> str | None:
    """A file is meant to be included if it reads many configurations of others, or if another file mentions it."""
    if len(missing) > 2 or robot.launch.is_named_elsewhere(expansion.entry):
        return "info"
    certain = used.file is expansion.entry and not used.conditions and used.file.format == "python"
    return None if certain else "warning"
