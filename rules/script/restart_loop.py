"""A loop starts ROS again without a pause.

## What it finds
`while true` (or `:`) whose body runs `ros2 launch` or `ros2 run` in the foreground, and otherwise
only commands that surely do not wait and do not leave the loop (`echo`, `source`, `rm`, ...).

## Why it matters on a robot
Where a device is missing or a setup file is wrong, the launch ends at once and starts again, several times a second:
the log fills the disk, motors are switched on and off, and neither systemd nor a person sees that anything failed.

## Bad
```sh
while true; do
  ros2 launch tug base.launch.py
done
```

## Good
```sh
while true; do
  ros2 launch tug base.launch.py
  sleep 5
done
```

A unit with `Restart=on-failure`, `RestartSec=5` and a start limit does it better.

## When to ignore it
When the program waits long itself before it ends.

## References
- systemd.service(5), "Restart=" and "RestartSec="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import shell_blocks
from bringup_lint.api.shell import unwrapped

ENDLESS = ("true", ":")
QUICK = frozenset(
    "echo printf : true source . export unset set date cd [ [[ test logger rm mkdir pkill killall kill tee".split()
)
"""Commands that do not wait and do not leave the loop."""


@rule("warning", silent="the launch starts again at once")
def restart_loop(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and "ros2" in source.text and "done" in source.text:
            for started in _loops(shell_blocks(source)):
                yield finding(
                    started,
                    "The loop starts this again without a pause: where it fails at once, it fails many times a second",
                    advice="add 'sleep 5' after it, or let systemd restart it with RestartSec= and a start limit",
                )


def _loops(blocks: tuple[Block, ...]) -> Iterator[Located]:
    for block in blocks:
        if block.kind == "loop" and _is_endless(block):
            inside = list(_commands(block.bodies[0]))
            started = next((found for each in inside if (found := _started(each))), None)
            if started is not None and all(map(_is_quick, inside)):
                yield started
        else:
            for body in block.bodies:
                yield from _loops(body)


def _is_endless(block: Block) -> bool:
    commands = [each.command for each in block.condition if each.command is not None]
    return len(commands) == 1 and commands[0].name in ENDLESS


def _commands(blocks: tuple[Block, ...]) -> Iterator[Command]:
    for block in blocks:
        if block.command is not None:
            yield block.command
        for body in (block.condition, *block.bodies):
            yield from _commands(body)


def _is_quick(command: Command) -> bool:
    words = unwrapped(command.words)
    if any("$(" in each.span.text or "`" in each.span.text for each in (*command.assignments, *words)):
        return False
    return not words or words[0] in QUICK or _started(command) is not None


def _started(command: Command) -> Located | None:
    """``ros2`` where it starts something and the loop waits for its end."""
    words = unwrapped(command.words)
    if len(words) < 2 or words[0] != "ros2" or words[1] not in ("launch", "run") or command.ends == "&":
        return None
    return words[0]
