"""launch starts a program that reads the keyboard.

## What it finds
Nodes that read keys from their terminal, started by a launch file without a `prefix` that opens one: those of
teleop_twist_keyboard, turtlebot3_teleop, key_teleop and turtlesim, and programs of the tree that set up the terminal of
their standard input and do not ask whether it is one. An argument that asks for the node cannot make it work.

## Why it matters on a robot
launch gives its processes a pipe as the standard input, with `emulate_tty`, too. The node ends at once with
"termios.error: (25, 'Inappropriate ioctl for device')", and nobody can drive by the keys.

## Bad
```python
Node(package='teleop_twist_keyboard', executable='teleop_twist_keyboard')
```

## Good
```python
Node(package='teleop_twist_keyboard', executable='teleop_twist_keyboard', prefix='xterm -e')
```

Over ssh, `ros2 run teleop_twist_keyboard teleop_twist_keyboard` in a terminal of its own.

## When to ignore it
When a launch configuration `launch-prefix` is always passed.

## References
- launch, `ExecuteLocal`, and osrf_pycommon, `async_execute_process`: the standard input is a pipe
- teleop_twist_keyboard, README
- termios(3), ENOTTY
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import Started
from bringup_lint.api.launch import literal_text

READERS = {
    "teleop_twist_keyboard": "teleop_twist_keyboard",
    "turtlebot3_teleop": "teleop_keyboard",
    "key_teleop": "key_teleop",
    "turtlesim": "turtle_teleop_key",
}
READS_KEYS = regex(r"\btcgetattr\((?:sys\.)?stdin\b", hints="tcgetattr")
ASKS = regex(r"\bisatty\(|/dev/tty\b|\bexcept\b[^\n:]{0,80}\btermios\.error\b")


@rule("warning", symptoms=["termios.error: (25, 'Inappropriate ioctl for device')"])
def keyboard_without_terminal(robot: Robot) -> Iterator[Finding]:
    for node in robot.launch.nodes:
        if "prefix" in node.options or not node.file.source.judged or robot.purpose(node.span).value in ("ci", "test"):
            continue
        where = reader(robot, node)
        if where is None or "launch-prefix" in robot.launch.expansion(node.file).arguments:
            continue
        yield finding(
            node.span,
            f"{node.label()} reads keys from its terminal, and launch gives it a pipe: it ends at its start",
            advice="write prefix='xterm -e', or start it by ros2 run in a terminal of its own",
            related=[note(where, "here it asks for the terminal")] if where is not node.span else [],
            chain=robot.provenance.chain_to_node(node),
        )


def reader(robot: Robot, node: Started) -> Span | None:
    """Where a program reads keys, or the node itself when it is a public one that does."""
    package, program = literal_text(node.package), literal_text(node.executable)
    if package is None or program is None:
        return None
    own = robot.nodes.program_of(node)
    if own is None:
        is_public = READERS.get(str(package)) == str(program).removesuffix(".py")
        return node.span if is_public and package not in robot.launch.workspace.packages else None
    found = READS_KEYS.search(own.file.source.text)
    return own.file.source.span(*found.span()) if found and not ASKS.search(own.file.source.text) else None
