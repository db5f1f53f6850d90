"""A launch configuration is used before it is declared.

## What it finds
A launch configuration that is read in the description before its `DeclareLaunchArgument` (`<arg>`). A read under a
condition is a warning. Silent where every command of the tree that launches the file passes the argument.

## Why it matters on a robot
launch visits the description in order. At the time of the read the configuration does not exist, and launch aborts.

## Bad
```python
LaunchDescription([
    Node(package='demo', executable='talker', namespace=LaunchConfiguration('robot_name')),
    DeclareLaunchArgument('robot_name', default_value='robot'),
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
When every caller sets the argument before it includes this file, or passes it on the command line. Moving the
declaration up costs nothing and is the better choice.

## References
- launch, `LaunchConfiguration.perform` and `DeclareLaunchArgument.execute`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.python import move_before


@rule("error", fix="safe", symptoms=["launch configuration '*' does not exist"])
def arg_used_before_declare(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        passed = robot.runners.always_passed(expansion.entry)
        declared = {each.name: each for each in expansion.declared if each.file is expansion.entry}
        for used in expansion.unbound:
            later = declared.get(str(used.argument.name))
            if later is None or not used.certain or used.file is not expansion.entry or later.name in passed:
                continue
            move = move_before(later.action.span, used.argument.name.span)
            yield finding(
                used.argument.name,
                f"'{later.name}' is used before it is declared: launch aborts",
                advice="move the declarations to the start of the description",
                fix=fix(f"move the declaration of '{later.name}' before its use", codemod=move) if move else None,
                related=[note(later.action.span, "declared here, later in the description")],
                severity="warning" if used.conditions else None,
            )
