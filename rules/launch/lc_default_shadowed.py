"""The default of a LaunchConfiguration never applies.

## What it finds
`LaunchConfiguration('x', default=D)` in a file that also declares `x` with another default. It is a warning where the
declared default is empty and the other one is a path, but in packages of others that the tree only holds; else it is an
info.

## Why it matters on a robot
The declaration runs first and binds `x`, even to an empty string. The default at the place of use looks like a
fallback but never applies: nav2 gets `params_file:=''` instead of the file that is written there.

## Bad
```python
params = LaunchConfiguration('params_file', default='/etc/robot/nav2.yaml')
LaunchDescription([DeclareLaunchArgument('params_file', default_value=''), Node(parameters=[params], ...)])
```

## Good
```python
params = LaunchConfiguration('params_file')
LaunchDescription([
    DeclareLaunchArgument('params_file', default_value='/etc/robot/nav2.yaml'),
    Node(parameters=[params], ...),
])
```

## When to ignore it
Never: launch does not use the second default. Delete it, or move it into the declaration.

## References
- launch, `LaunchConfiguration.perform` and `DeclareLaunchArgument.execute`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.python import without_keyword


@rule("info", fix="unsafe", silent="launch takes the declared default without a message")
def lc_default_shadowed(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        declared = {
            each.name: each.action
            for each in robot.launch.expansion(file).declared
            if each.file is file and not each.conditions and each.action.default is not None
        }
        for read in file.reads:
            action = declared.get(str(read.name))
            default = action.default if action is not None else None
            if action is None or default is None or read.default is None or launch.same(read.default, default):
                continue
            if any(isinstance(each, launch.Argument) and each.name == read.name for each in launch.walk(default)):
                continue
            if not (launch.understood(read.default) and launch.understood(default)):
                continue
            if means_the_same(robot.launch.text(default, file), robot.launch.text(read.default, file)):
                continue
            empty = launch.literal(action.default) == ""
            declaration = "The declared default ''" if empty else "The default of the declaration"
            drop = without_keyword(read.default.span)
            yield finding(
                read.default.span,
                f"{declaration} applies: this default of '{read.name}' is never used",
                advice="move the default into the declaration",
                related=[note(action.span, "declared here")],
                fix=fix("remove the default that is never used", codemod=drop, safe=False) if drop else None,
                severity="warning" if empty and _is_lost(robot, read.default, file) else None,
            )


def _is_lost(robot: Robot, default: launch.Value, file: launch.LaunchFile) -> bool:
    """Whether a path that never applies is of the robot's own files."""
    return "/" in (robot.launch.text(default, file) or "") and not robot.launch.workspace.is_vendored(file.source)


def means_the_same(first: str | None, second: str | None) -> bool:
    """Whether launch or a node makes the same of two texts: ``False`` and ``false``, ``1`` and ``1.0``."""
    if first is None or second is None:
        return False
    if first.strip().lower() == second.strip().lower():
        return True
    try:
        return float(first) == float(second)
    except ValueError:
        return False
