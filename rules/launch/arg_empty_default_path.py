"""A path argument is empty unless a value is passed.

## What it finds
Arguments with the default `''` that are used as a parameter file or as the file of an include, or that are passed
on as `params_file`. Uses whose condition tests the argument are not reported, nor arguments whose description says
that they are optional.

## Why it matters on a robot
If the launch file is started without the argument, the node uses the defaults of its code instead of the robot's
parameters, or the include fails.

## Bad
```python
DeclareLaunchArgument('params_file', default_value=''),
Node(package='demo', executable='planner', parameters=[LaunchConfiguration('params_file')]),
```

## Good
```python
DeclareLaunchArgument('params_file', default_value=PathJoinSubstitution([share, 'config', 'planner.yaml'])),
Node(package='demo', executable='planner', parameters=[LaunchConfiguration('params_file')]),
```

## When to ignore it
When every caller passes the argument and the callers are outside this tree, for example a launch file of another
repository. Removing the default is still better: launch then reports the missing argument.

## References
- launch_ros, `Node`: "Parameter file path is not a file"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

OPTIONAL = regex(r"optional|if (?:it is )?(?:not set|unset|empty)|(?:leave|left) empty|empty (?:=|means|for)", re.I)
"""What a description says of an argument that may be empty."""


@rule("warning", symptoms=["Parameter file path is not a file"])
def arg_empty_default_path(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        expansion = robot.launch.expansion(file)
        empty = {
            each.name: (each.action.default.span, launch.text_of(each.action.description) or "")
            for each in expansion.declared
            if each.file is file and each.action.default is not None and launch.literal(each.action.default) == ""
        }
        if not empty:
            continue
        guards = conditions(expansion)
        for action, owner in expansion.actions:
            if owner is not file:
                continue
            for value, what in paths(action):
                name = str(value.name) if isinstance(value, launch.Argument) else ""
                if name not in empty:
                    continue
                place, description = empty[name]
                if OPTIONAL.search(description):
                    continue
                if any(name in names(each.predicate) for each in guards.get(id(action), action.conditions)):
                    continue
                yield finding(
                    place,
                    f"The path '{name}' is empty unless it is passed: {what}",
                    advice="give the argument a real default, or remove the default, so that launch requires a value",
                    related=[note(value.span, "used as a path here")],
                )


def conditions(expansion: launch.Expansion) -> dict[int, tuple[launch.Condition, ...]]:
    """The conditions of nodes and includes, with those of the groups around them, by the ``id`` of the action."""
    found = {id(node.action): node.conditions for node in expansion.nodes}
    return found | {id(each.action): each.conditions for each in expansion.includes}


def paths(action: launch.Action) -> Iterator[tuple[launch.Value, str]]:
    """The values of an action that are used as a path, with what happens when they are empty."""
    for source in getattr(action, "parameters", ()):
        if isinstance(source, launch.ParameterFile):
            source = source.file
        if isinstance(source, launch.DerivedFile):
            yield source.base, "the parameter file cannot be opened and launch aborts"
        else:
            yield source, "the node starts without its parameter file"
    if isinstance(action, launch.Include):
        yield action.file, "the include fails"
        for key, value in action.arguments:
            if launch.literal(key) == "params_file":
                yield value, "the included file gets no parameter file"


def names(value: launch.Value) -> set[str]:
    return {str(each.name) for each in launch.walk(value) if isinstance(each, launch.Argument)}
