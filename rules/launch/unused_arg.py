"""A launch argument is declared but never read.

## What it finds
Declared arguments that neither the file nor any file that it includes reads. A variable that is only the default of
the argument itself does not read it, and a key of a dictionary neither. Info in packages of others that the tree only
holds.

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

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import rule
from bringup_lint.api.launch import OF_LAUNCH
from bringup_lint.api.launch import LaunchFile
from bringup_lint.api.python import remove


@rule("warning", fix="unsafe", silent="launch accepts the argument without a message")
def unused_arg(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        own = robot.launch.expansion(file)
        if own.open or any(each.reads_all for each in own.files):
            continue
        is_idle = not own.nodes and not own.includes and not own.handlers
        files = {id(each): each for expansion in robot.launch.leading_to(file) for each in expansion.files}
        elsewhere = launch.read_in(robot.launch, (each for each in files.values() if each is not file))
        for declared in own.declared:
            name = declared.name
            if declared.file is not file or name in elsewhere or name in OF_LAUNCH:
                continue
            dead = launch.dead_reads(file, name)
            if sum(argument.name == name for argument in file.reads) > dead or mentioned(robot, file, name) > 1 + dead:
                continue
            if any(f"$(var {name}" in source.text for source in robot.of_kind("params")):
                continue
            drop = remove(declared.action.span)
            yield finding(
                declared.action.name.span,
                f"'{name}' is declared but nothing reads it: setting it has no effect",
                advice="use the argument, or remove the declaration",
                fix=fix(f"remove the declaration of '{name}'", codemod=drop, safe=False) if drop else None,
                severity="info" if is_idle or robot.launch.workspace.is_vendored(file.source) else None,
            )


def mentioned(robot: Robot, file: LaunchFile, name: str) -> int:
    """In Python only quoted names count: a variable may have the same name as the argument, and a key of a dictionary
    gives a parameter or an argument of another file."""
    if file.format != "python":
        return robot.launch.mentions(file, name)
    return len(re.findall(rf"""(['"]){re.escape(name)}\1(?!\s*:)""", file.source.text))
