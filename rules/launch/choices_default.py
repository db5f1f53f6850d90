"""The default of an argument is not one of its choices.

## What it finds
`DeclareLaunchArgument(..., choices=[...])` (`<choice>`) with a literal default that is not in the list.

## Why it matters on a robot
launch rejects the declaration. The file cannot be launched without passing the argument, or cannot be loaded at
all.

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
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule("error", symptoms=["is not in provided choices"])
def choices_default(robot: Robot) -> Iterator[Finding]:
    for _, action in robot.launch.actions(launch.DeclareArgument):
        default = launch.literal(action.default)
        known = [launch.literal(choice) for choice in action.choices or ()]
        choices = [choice for choice in known if choice is not None]
        if default is None or not choices or len(choices) < len(known) or default in choices:
            continue
        near = nearest(default, choices)
        yield finding(
            default,
            f"The default '{default}' is not one of the choices ({', '.join(choices)}): the file cannot be loaded",
            advice=f"write '{near[0]}'" if near else "use one of the choices as the default",
        )
