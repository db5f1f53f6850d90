"""A script gives up its clean-up with exec.

## What it finds
`trap '... kill ...' EXIT`, INT or TERM in a script that ends with `exec` of a program: no signal reaches the trap any
more. Silent where the trap is taken back before.

## Why it matters on a robot
`exec` puts the program in the place of the shell, and the traps are gone with it. What the script has started in the
background, which the trap was to end, goes on after the program has ended: a driver keeps its device, and the next
start fails.

## Bad
```sh
/opt/rover/bin/camera &
trap 'kill $!' EXIT
exec ros2 launch rover_bringup rover.launch.py
```

## Good
```sh
/opt/rover/bin/camera &
trap 'kill $!' EXIT
ros2 launch rover_bringup rover.launch.py
```

## When to ignore it
When the trap is only for a failure before `exec`.

## References
- bash(1), "SHELL BUILTIN COMMANDS", exec and trap
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import shell_commands

KILLS = regex(r"\b(?:kill|pkill|killall)\b")
SIGNALS = ("EXIT", "INT", "TERM", "SIGINT", "SIGTERM", "0")
LEAST = 3


@rule("warning", silent="the jobs in the background go on")
def trap_before_exec(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or "trap" not in source.text or "exec" not in source.text:
            continue
        trap: Located | None = None
        for command in shell_commands(source):
            words = command.words
            if command.depth or not words:
                continue
            if words[0] == "trap" and len(words) >= LEAST and any(word in SIGNALS for word in words[2:]):
                trap = words[0] if KILLS.search(words[1]) else None
            elif words[0] == "exec" and len(words) > 1 and trap is not None and command.ends not in ("||", "&&"):
                yield finding(
                    words[0],
                    "exec replaces this shell: the trap never runs, and what it was to end goes on",
                    advice="start the program without exec and let the script wait for it",
                    related=[note(trap, "the trap")],
                )
                break
