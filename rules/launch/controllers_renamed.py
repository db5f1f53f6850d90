"""A name for the controller manager renames all of its controllers.

## What it finds
`name=` of `ros2_control_node` up to Iron, in a launch file that also spawns controllers which need parameters. Silent
where the distribution is not known, where a parameter file gives joints to every node, and where the launch file gives
a controller a file of its own (`<controller>.params_file`).

## Why it matters on a robot
launch renames a process, not a node: every controller that the manager loads gets its name. Several nodes are called
alike, and none finds the parameters under its own name: diff_drive_controller and joint_trajectory_controller are not
configured, because their joints are empty. From Jazzy on controllers keep their names.

## Bad
```python
Node(package='controller_manager', executable='ros2_control_node', name='controller_manager', parameters=[controllers])
```

## Good
```python
Node(package='controller_manager', executable='ros2_control_node', parameters=[controllers])
```

## When to ignore it
When the robot has a newer ros2_control than its distribution, built from source.

## References
- https://github.com/ros-controls/ros2_control/issues/785
- https://github.com/ros-controls/ros2_control/issues/1684
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["Wheel names parameters are empty!"])
def controllers_renamed(robot: Robot) -> Iterator[Finding]:
    for each in robot.plugins.renamed_controllers:
        first = each.controllers[0]
        yield finding(
            each.name,
            f"In {each.distribution.capitalize()} this name is that of every controller of the process, too: "
            f"'{first}' gets no parameters and is not configured",
            advice="remove the name: the manager calls itself controller_manager",
            related=[note(name, f"'{name}' is spawned here") for name in each.controllers[:5]],
            chain=robot.provenance.chain_to_node(each.manager),
        )
