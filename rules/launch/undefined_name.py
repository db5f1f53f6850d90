"""A launch file uses a name that nothing imports or defines.

## What it finds
Names that the code of a Python launch file looks up and that nothing in the file binds: a class of launch whose import
is missing, a variable whose assignment was removed or commented out, a misspelt name. Only code that launch runs is
judged; it is a warning where it runs under a condition.

Silent in a `try` that catches the NameError, and in files with `import *`, `exec` and the like.

## Why it matters on a robot
The NameError ends launch before it starts a single node. A unit that runs it fails at every boot.

## Bad
```python
from launch import LaunchDescription

def generate_launch_description():
    return LaunchDescription([Node(package='rover', executable='drive')])
```

## Good
```python
from launch import LaunchDescription
from launch_ros.actions import Node
```

## When to ignore it
When something that imports the file puts the name into it before it runs.

## References
- https://docs.python.org/3/reference/executionmodel.html, "Resolution of names"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import module_of


@rule("error", symptoms=["trying to load file of format [py]: - NameError: name '*' is not defined"])
def undefined_name(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        certain = [each.name for each in file.unbound if not each.is_conditional]
        for name, is_conditional, arguments in file.unbound:
            if name in certain[1:]:
                continue  # Python has stopped at the first
            module = module_of(name)
            others = certain[1:] if not is_conditional else []
            yield finding(
                name,
                f"NameError: {name} is never {'imported' if module else 'defined'}, and nothing starts"
                + (f" when {' and '.join(arguments)} lead{'s' * (len(arguments) == 1)} here" if arguments else ""),
                advice=f"add 'from {module} import {name}'" if module else f"define {name} before it is used",
                related=[note(each, f"{each} would be the next") for each in others],
                severity="warning" if is_conditional else None,
            )
