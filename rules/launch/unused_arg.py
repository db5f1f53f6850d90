"""A launch argument is declared but never read.

## What it finds
Declared arguments that neither the file nor any file that it includes reads. A variable that is only the default of
the argument itself does not read it, a key of a dictionary neither, nor a file that only hands it on to this one. Of
included files that are not in the tree, those of Gazebo, Nav2, slam_toolbox and others are known. With others, the rule
is silent where the file includes them itself, or where they are handed nothing: they may read any argument. Info in
packages of others that the tree only holds, and where other launch files may be included in its place: another one of
this name declares the argument too, `vehicle_interface.launch.xml` of several vehicles, or the argument is passed to a
file whose path is computed.

## Why it matters on a robot
Setting the argument has no effect, and launch does not say so. The robot runs with another configuration than the
operator expects.

## Bad
```python
LaunchDescription([
    DeclareLaunchArgument('camera_config', default_value='default.yaml'),
    Node(package='camera', executable='camera_node'),
])
```

## Good
```python
LaunchDescription([
    DeclareLaunchArgument('camera_config', default_value='default.yaml'),
    Node(package='camera', executable='camera_node', parameters=[LaunchConfiguration('camera_config')]),
])
```

## When to ignore it
When the argument is part of an interface that several launch files share, and this file deliberately accepts but
does not use it.

## References
- launch, scope of launch configurations
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.python import remove


@rule("warning", fix="unsafe", silent="launch accepts the argument without a message")
def unused_arg(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        if robot.purpose(file.source).value in ("ci", "test", "archive"):
            continue
        own = robot.launch.expansion(file)
        is_idle = not own.nodes and not own.includes and not own.handlers
        for declared, passed, is_shared, instead in launch.unread_arguments(robot.launch, file):
            name = declared.name
            if any(f"$(var {name}" in source.text for source in robot.of_kind("params")):
                continue
            drop = remove(declared.action.span) if instead is None else None
            yield finding(
                declared.action.name.span,
                f"'{name}' is declared but nothing reads it: setting it has no effect",
                advice=f"read '{name}' there" if instead else "use the argument, or remove the declaration",
                related=[
                    *([note(instead.span, f"this variable reads '{instead.name}'")] if instead else ()),
                    *(note(each, "passed here") for each in passed),
                ],
                fix=fix(f"remove the declaration of '{name}'", codemod=drop, safe=False) if drop else None,
                severity="info" if is_idle or is_shared or robot.launch.workspace.is_vendored(file.source) else None,
            )
