"""A launch argument is declared and nothing reads it.

## What it finds
Declared arguments that neither the file nor any file that it includes reads.

## Why it matters on a robot
Setting the argument has no effect, and launch does not say so: the robot runs with another configuration than the operator
believes.

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

## References
- launch, scope of launch configurations
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning")
def unused_arg(robot: Robot):
    for file in robot.launch.judged:
        expansions = list(robot.launch.leading_to(file))
        files = {id(each): each for expansion in expansions for each in expansion.files}
        if any(expansion.open for expansion in expansions) or robot.launch.reads_unseen(files.values()):
            continue
        read = {str(argument.name) for each in files.values() for argument in each.reads}
        for declared in robot.launch.expansion(file).declared:
            if declared.file is not file or declared.name in read:
                continue
            if robot.launch.mentions(file, declared.name) > 1:
                continue
            yield finding(
                declared.action.name.span,
                f"'{declared.name}' is declared but nothing reads it: setting it has no effect",
                advice="use the argument, or remove the declaration",
            )
