"""The parameters of a node are not what launch_ros takes.

## What it finds
`parameters=` that is a dictionary or a text instead of a list, and in the dictionaries of the list keys that are no
text and lists of lists.

## Why it matters on a robot
launch_ros raises a TypeError while the file is loaded: nothing starts.

## Bad
```python
Node(package='demo', executable='driver', parameters={'rate': 50})
```

## Good
```python
Node(package='demo', executable='driver', parameters=[{'rate': 50}])
```

## When to ignore it
Never; launch does not start.

## References
- launch_ros, `normalize_parameters`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

WRONG = {
    "not-a-list": ("parameters= is no list", "put it into a list"),
    "key": ("The name of a parameter is no text", "quote it"),
    "nested-list": ("A parameter is a list of lists", "write a flat list"),
}


@rule("error", symptoms=["Expecting list of parameters", "Unexpected type for parameter value"])
def parameters_invalid(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for problem in file.refused:
            wrong, advice = WRONG[problem.code]
            yield finding(problem.where, f"{wrong}: launch ends with a TypeError", advice=advice)
