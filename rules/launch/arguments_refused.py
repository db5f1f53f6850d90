"""A program cannot use the words that a launch file gives it.

## What it finds
- `ExecuteProcess(cmd=['ros2 topic pub ...'])` without `shell=True`: launch looks for a program with blanks in its name
- `arguments=['--ros-args -r __ns:=/left']` in Python: one word, which rcl does not take for ROS arguments
- `static_transform_publisher` with another number of arguments than it takes: 8 (x y z yaw pitch roll frame child),
  9 (with a quaternion) or options alone

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

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import regex
from bringup_lint.api import rule

PROGRAM = regex(r"[a-z][\w.+-]*\s+\S")
"""A program without its path, and the first of its arguments."""
LENGTHS = (0, 8, 9)
STATIC = "static_transform_publisher"


@rule(
    "error",
    symptoms=[
        "FileNotFoundError: [Errno 2] No such file or directory: 'ros2 *'",
        "static_transform_publisher exited with code 1 because of missing arguments",
    ],
)
def arguments_refused(robot: Robot) -> Iterator[Finding]:
    for file, action in robot.launch.actions(launch.Process):
        if file.source.kind == "launch-python" and not action.open:
            yield from of_process(action)
    judged = {id(file) for file in robot.launch.judged}
    for node in robot.launch.nodes:
        if id(node.file) not in judged or not node.is_node or getattr(node.action, "open", False):
            continue
        if isinstance(node.action, launch.ComposableNode):
            continue
        yield from of_ros_arguments(node)
        if launch.literal_text(node.executable) == STATIC and launch.literal_text(node.package) == "tf2_ros":
            yield from of_transform(node)


def of_process(action: launch.Process) -> Iterator[Finding]:
    """A command in one word, which launch does not give to a shell."""
    if isinstance(action, launch.Node) or not action.cmd or "shell" in action.options:
        return
    first = action.cmd[0]
    text = launch.literal_text(first)
    if PROGRAM.match(text) if text is not None else _goes_on(first):
        yield finding(
            first.span,
            "launch looks for a program whose name is this whole text, and finds none: the process is not started",
            advice="give each word as an element of its own",
        )


def _goes_on(value: launch.Value) -> bool:
    """Whether text after a blank follows a part that is computed."""
    if not isinstance(value, launch.Concat):
        return False
    texts = (launch.literal_text(part) for part in value.parts[1:])
    return any(text is not None and text[:1].isspace() and text.strip() for text in texts)


def of_ros_arguments(node: launch.Started) -> Iterator[Finding]:
    for value in node.arguments:
        text = launch.literal_text(value)
        if text is not None and text.startswith("--ros-args ") and text.span.source.kind == "launch-python":
            yield finding(
                text,
                "This is one word, which rcl does not read as ROS arguments: they have no effect",
                advice="give each word as an element of its own",
            )


def of_transform(node: launch.Started) -> Iterator[Finding]:
    words = list(_own(node))
    if None in words or any(word.startswith("--") for word in words if word is not None):
        return
    if len(words) not in LENGTHS:
        yield finding(
            node.arguments[0].span if len(words) == 1 else node.span,
            f"{STATIC} takes 8 or 9 arguments and gets {len(words)}: it ends, and the frame does not exist",
            advice="give x y z yaw pitch roll frame child, each as an element of its own",
            severity="warning" if node.by_default is not True else None,
        )


def _own(node: launch.Started) -> Iterator[Located | str | None]:
    """The words before the ROS arguments; None for one that may be several."""
    for value in node.arguments:
        text = launch.literal_text(value)
        if text == "--ros-args":
            return
        is_one = isinstance(value, (launch.Argument, launch.Concat, launch.PathJoin))
        yield text if text is not None else "?" if is_one and launch.understood(value) else None
