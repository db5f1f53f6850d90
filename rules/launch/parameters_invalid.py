"""The parameters or remappings of a node are not what launch_ros takes.

## What it finds
`parameters=` that is a dictionary, a text, a substitution or one file instead of a list, actions such as
`OpaqueFunction`, numbers and None in the list, and in its dictionaries keys that are not strings, None, lists of lists
and lists of dictionaries. `remappings=` with anything but tuples of two.

## Why it matters on a robot
launch_ros raises an exception while the file is loaded: nothing starts.

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
- launch_ros, `normalize_parameters` and `normalize_remap_rule`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.python import in_list

WRONG = {
    "not-a-list": ("parameters= is not a list", "put it into a list"),
    "no-list": ("parameters= of this node is not a list", "put it into a list"),
    "action": ("An action is given as parameters", "start the node in the OpaqueFunction, with what it computes"),
    "value": ("A number, truth value or None stands among the parameters without a name", "write {'name': value}"),
    "key": ("The name of a parameter is not a string", "quote it"),
    "nested-list": ("A parameter is a list of lists", "write a flat list"),
    "list-of-maps": ("A parameter is a list of dictionaries", "write a list of names, and a dictionary for each name"),
    "nothing": ("A parameter is None", "give a value, or leave the parameter out"),
    "remapping": ("A remapping is no tuple of two names", "write ('from', 'to')"),
}


@rule(
    "error",
    fix="safe",
    symptoms=[
        "Expecting list of parameters",
        "Unexpected type for parameter value",
        "Expected a non-empty sequence, with items of uniform type",
    ],
)
def parameters_invalid(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for problem in file.refused:
            wrong, advice = WRONG[problem.code]
            listed = in_list(problem.where) if problem.code == "not-a-list" else None
            yield finding(
                problem.where,
                f"{wrong}: launch ends with an exception",
                advice=advice,
                fix=fix("put it into a list", codemod=listed) if listed else None,
            )
