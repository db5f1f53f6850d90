"""A launch file makes an action and never adds it to the launch description.

## What it finds
Nodes, includes and other actions of launch that a function of a Python launch file gives to a variable which nothing
reads, or makes in a statement of their own. Left alone is what a comment mentions, because it was taken out on purpose,
and the declaration of an argument that the file reads for something, which `launch/undeclared-arg` judges. It is an
info where nothing shows that it is missed: the file starts the same executable by another action, it is a window such
as RViz, a static transform or, beside one that starts, another program for transforms, or an argument that nothing
reads.

## Why it matters on a robot
launch starts only what the description holds: the node does not run, and no message says so. A filter or a driver
is missing although the launch file seems to start it.

## Bad
```python
def generate_launch_description():
    drive = Node(package='rover_drive', executable='drive')
    laser_filter = Node(package='laser_filters', executable='scan_to_scan_filter_chain')
    return LaunchDescription([drive])
```

## Good
```python
def generate_launch_description():
    drive = Node(package='rover_drive', executable='drive')
    laser_filter = Node(package='laser_filters', executable='scan_to_scan_filter_chain')
    return LaunchDescription([drive, laser_filter])
```

## When to ignore it
When the action is kept for later. A comment that names its variable says so, too.

## References
- launch, `LaunchDescription.add_action`
"""

from collections import Counter
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import regex
from bringup_lint.api import rule

_EFFECTS = {
    "DeclareLaunchArgument": "the argument is not declared",
    "IncludeLaunchDescription": "nothing of that launch file starts",
    "RegisterEventHandler": "the event has no handler",
}
_STARTING = frozenset(
    ("Node", "LifecycleNode", "ComposableNodeContainer", "ExecuteProcess", "ExecuteLocal", "LoadComposableNodes")
)

_WINDOW = regex(r"(?i)rviz|rqt|(?<![a-z])gui(?![a-z])|visuali[sz]|foxglove|plotjuggler")
"""Of the name of a program that only shows something."""
_STATIC = "static_transform_publisher"
_TRANSFORMS = regex(r"^(?:static_)?(?:tf2?|transforms?)_?(?:pub|publisher|broadcast|broadcaster)$")
OF_MANY_NODES = (_STATIC, "spawner", "parameter_bridge", "create", "spawn_entity.py", "relay")
"""Executables that a launch file starts several times, each for something else."""


@rule("warning", silent="launch starts what the description holds, without a message")
def action_unplaced(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        read = Counter(str(each.name) for each in file.reads)
        for each in file.unplaced:
            if each.owner == "DeclareLaunchArgument" and read[each.name] > launch.dead_reads(file, each.name):
                continue
            effect = "it never starts" if each.owner in _STARTING else _EFFECTS.get(each.owner, "it has no effect")
            is_idle = (
                robot.launch.workspace.is_vendored(file.source)
                or is_replaced(robot, file, each)
                or is_spare(robot, file, each)
            )
            name = f"'{each.variable}' is" if each.is_kept else "is"
            yield finding(
                each.variable,
                f"{each.owner} {name} made and not added to the launch description: {effect}",
                advice="add it to the launch description, or remove it",
                severity="info" if is_idle else None,
            )


def is_spare(robot: Robot, file: launch.LaunchFile, made: launch.UnplacedAction) -> bool:
    """Whether the robot does its work without the action, as far as anybody can tell: many a transform that is left
    out is in the description of the robot, too, or another action publishes it; and nothing reads the argument."""
    if made.owner == "DeclareLaunchArgument":
        return True
    is_window = any(map(_WINDOW.search, (made.executable, made.name, made.variable if made.is_kept else "")))
    is_static = made.executable == _STATIC
    is_transform = is_static or (_TRANSFORMS.search(made.executable) and _STATIC in started_by(robot, file))
    return made.owner in _STARTING and bool(is_transform or is_window)


def is_replaced(robot: Robot, file: launch.LaunchFile, made: launch.UnplacedAction) -> bool:
    """Whether the file starts the same executable by another action, so that this one may be a leftover."""
    if not made.executable or made.executable in OF_MANY_NODES:
        return False
    return made.executable in started_by(robot, file)


def started_by(robot: Robot, file: launch.LaunchFile) -> list[str | None]:
    """The executables that a file starts itself, as far as they are known."""
    return [launch.literal(each.executable) for each in robot.launch.expansion(file).nodes if each.file is file]
