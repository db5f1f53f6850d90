"""A program cannot use the words that a launch file gives it.

## What it finds
- `ExecuteProcess(cmd=['ros2 topic pub ...'])` without `shell=True`: launch looks for a program with blanks in its name
- `arguments=['--ros-args -r __ns:=/left']` in Python: one word, which rcl does not take for ROS arguments
- `static_transform_publisher` with another number of arguments than it takes: 8 (x y z yaw pitch roll frame child),
  9 (with a quaternion) or options alone; and with options (`--frame-id`) before Humble
- yaw, pitch and roll of `static_transform_publisher` above 2π: they are in radians (a warning)
- arguments that are called roll and yaw where `static_transform_publisher` takes yaw, pitch and roll (a warning)
- words of `parameter_bridge` that are not `topic@package/msg/Type[gz.msgs.Type`, with `[`, `]` or `@`: without the
  types it ends, and a type in another form is not bridged (a warning)
- `'-entity' 'bucket'` among the arguments, without a comma: one word
- `Command(['xacro', path])` without a blank after the program, `Command(['xacro ', path, 'name:=', value])` without one
  before an argument, and `Command([path])` of a robot description without a program

## Why it matters on a robot
launch splits nothing that is already a list. In the first case the process is not started (FileNotFoundError), and
launch shuts down. ROS arguments in one word are ignored without a message: the node comes up under its default name and
parameters. `static_transform_publisher` prints its usage and ends, and everything that needs the frame waits for it.

## Bad
```python
Node(package='tf2_ros', executable='static_transform_publisher', arguments=['0 0 0.2 0 0 0 base_link laser'])
```

## Good
```python
Node(package='tf2_ros', executable='static_transform_publisher',
     arguments='0 0 0.2 0 0 0 base_link laser'.split())
```

## When to ignore it
When the program itself splits its arguments.

## References
- launch, execute_local.py: the words of `cmd` are joined for a shell only
- geometry2, static_transform_broadcaster_program.cpp
"""

import math
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule

WITHOUT_FLAGS = ("dashing", "eloquent", "foxy", "galactic")
SPLIT = "give each word as an element of its own"
JOINED = {
    "program": (
        "launch joins the parts of a command without blanks: no program has this name, and launch aborts",
        "write 'xacro ' with a blank at its end",
    ),
    "file": (
        "launch joins the parts of a command without blanks: the name of the file goes on with '{}:=', no file has it, "
        "and launch aborts",
        "write ' {}:=' with a blank before it",
    ),
    "option": (
        "launch joins the parts of a command without blanks: '{}' is one word, and its second argument a part of the "
        "first one's value",
        "write a blank before the name of the second argument",
    ),
    "description": (
        "launch runs this file as a program: a robot description is none, and launch aborts",
        "write 'xacro ' before the path",
    ),
}


@rule(
    "error",
    symptoms=[
        "FileNotFoundError: [Errno 2] No such file or directory: 'ros2 *'",
        "static_transform_publisher exited with code 1 because of missing arguments",
        "Failed to create a bridge for topic * with ROS2 type * to topic * with Gazebo Transport type",
    ],
)
def arguments_refused(robot: Robot) -> Iterator[Finding]:
    for program in launch.unsplit_commands(robot.launch):
        yield finding(
            program.span,
            "launch looks for a program whose name is this whole text, and finds none: the process is not started",
            advice=SPLIT,
        )
    for text in launch.unsplit_ros_arguments(robot.launch):
        yield finding(
            text,
            "This is one word, which rcl does not read as ROS arguments: they have no effect",
            advice=SPLIT,
        )
    for text, option in launch.options_with_next(robot.launch):
        yield finding(
            text,
            f"A comma is missing after '{option}': Python joins both texts, and the program gets the one word '{text}'",
            advice="write a comma between them",
        )
    for node, count in launch.refused_transforms(robot.launch):
        yield finding(
            node.arguments[0].span if count == 1 else node.span,
            f"static_transform_publisher takes 8 or 9 arguments and gets {count}: it ends, and the frame does not "
            "exist",
            advice="give x y z yaw pitch roll frame child, each as an element of its own",
            severity="warning" if node.by_default is not True else None,
        )
    for word, type_ in launch.unbridged(robot.launch):
        yield finding(
            word,
            f"parameter_bridge knows no type '{type_}': the topic is not bridged"
            if type_ is not None
            else "parameter_bridge cannot read this word: it prints its usage and ends, and nothing is bridged",
            advice="write topic@package/msg/Type[gz.msgs.Type",
            severity=None if type_ is None else "warning",
        )
    yield from unspaced(robot)
    yield from transforms(robot)


def unspaced(robot: Robot) -> Iterator[Finding]:
    for joined in launch.joined_commands(robot.launch):
        effect, advice = JOINED[joined.how]
        yield finding(joined.place.span, effect.format(joined.text), advice=advice.format(joined.text))


def transforms(robot: Robot) -> Iterator[Finding]:
    for angle, number in launch.in_degrees(robot.launch):
        yield finding(
            angle,
            f"{angle} is in radians, {abs(number) / math.tau:.1f} turns: the frame does not point where it should",
            advice=f"write {math.radians(number):.4g}",
            severity="warning",
        )
    for first, last in launch.turned(robot.launch):
        yield finding(
            first.name,
            f"static_transform_publisher takes yaw, pitch and roll in this order, and gets '{first.name}' as the yaw: "
            "the frame does not point where it should",
            advice=f"write '{last.name}' here, and '{first.name}' as the last angle",
            related=[note(last.name, "this is taken for the roll")],
            severity="warning",
        )
    if robot.target.ros not in WITHOUT_FLAGS:
        return
    for flag in launch.unknown_flags(robot.launch):
        yield finding(
            flag,
            f"static_transform_publisher has no options in {robot.target.ros.capitalize()}: it ends, and the frame "
            "does not exist",
            advice="give x y z yaw pitch roll frame child, each as an element of its own",
        )
