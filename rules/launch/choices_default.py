"""The value of an argument is not one of its choices.

## What it finds
`DeclareLaunchArgument(..., choices=[...])` (`<choice>`) with a literal default that is not in the list, and with a
value that is not in the list and that an including launch file or a `ros2 launch` command of a unit, service or
script gives. A value that has the same name in the including file reaches the included one, also without being
passed. Where whoever launches the file may give another value, it is a warning.

## Why it matters on a robot
launch rejects the declaration. The file cannot be launched without passing the argument, or cannot be loaded at
all. An included file ends the whole launch with "provided value ... is not valid".

## Bad
```python
DeclareLaunchArgument('lidar', default_value='a1', choices=['a2', 'a3'])
```

## Good
```python
DeclareLaunchArgument('lidar', default_value='a2', choices=['a2', 'a3'])
```

## When to ignore it
Never: launch rejects such a declaration in every distribution.

## References
- launch, `DeclareLaunchArgument`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule("error", symptoms=["is not in provided choices", "is not valid. Valid options are"])
def choices_default(robot: Robot) -> Iterator[Finding]:
    yield from given(robot)
    for _, action in robot.launch.actions(launch.DeclareArgument):
        default = launch.literal(action.default)
        choices = launch.choices_of(action)
        if default is None or not choices or default in choices:
            continue
        near = nearest(default, choices)
        yield finding(
            default,
            f"The default '{default}' is not one of the choices ({', '.join(choices)}): the file cannot be loaded",
            advice=f"write '{near[0]}'" if near else "use one of the choices as the default",
        )


def given(robot: Robot) -> Iterator[Finding]:
    """What other launch files and commands give."""
    for each in launch.refused_choices(robot.launch, robot.runners):
        near = nearest(each.value, each.choices)
        yield finding(
            each.value,
            f"'{each.value}' is not one of the choices of '{each.declared.name}' ({', '.join(each.choices)}): launch "
            f"aborts{'' if each.always else ' with it'}",
            advice=f"give '{near[0]}'" if near else "give one of the choices, or add it to them",
            related=[note(each.declared.action.span, "declared here with its choices")],
            chain=robot.provenance.chain_to(each.value, f"'{each.value}' is given"),
            severity=None if each.always else "warning",
        )
