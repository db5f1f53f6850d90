"""A script goes on although a CAN bus did not come up.

## What it finds
`ip link set can0 ...`, or a script of the tree that does it, whose result nobody looks at, in a script without
`set -e`: before a `ros2 launch` or `ros2 run` of the same script, or with other commands after it in a script that
something of the tree starts by itself.

## Why it matters on a robot
A bus fails to come up when an adapter is unplugged or the module is not loaded. The script then starts the robot
without its motors, and ends with the status of its last command: systemd takes the set-up for done, and starts what is
ordered after it.

## Bad
```sh
#!/bin/bash
ip link set can0 up type can bitrate 500000
ros2 launch rover rover.launch.py
```

## Good
```sh
#!/bin/bash
set -e
ip link set can0 up type can bitrate 500000
exec ros2 launch rover rover.launch.py
```

## When to ignore it
When the robot is to drive without what is on the bus.

## References
- bash(1), "set": errexit
- https://docs.kernel.org/networking/can.html
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import STRICT
from bringup_lint.api.shell import Run

LOOKS = regex(STRICT + r"|\btrap [^\n]{0,200}\bERR\b|\$\?", re.M)
BUS = regex(r"can\d+")
SETS_UP = regex(r"\bip link (?:set|add) (?:dev )?['\"]?(?:can\d|\$)[^\n]{0,200}(?:\bup\b|type can)")
ARRAY = regex(r"\$\{(\w+)\[@\]\}")
DESCRIBING = ("echo", "printf", "exit", "true", "sleep", "")


@rule("warning", symptoms=["Cannot find device can"])
def can_setup_unchecked(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or LOOKS.search(source.said):
            continue
        runs = [did for did in robot.scripts.done(source) if isinstance(did, Run)]
        ignored = [at for at, run in enumerate(runs) if run.command.ends not in ("||", "&&") and _sets_up(robot, run)]
        if not ignored:
            continue
        after = runs[ignored[0] + 1 :]
        ros = next((run for run in after if _starts_ros(run, source)), None)
        first, *others = [runs[at] for at in ignored]
        if ros is None and not (robot.scripts.starts_by_itself(source) and _goes_on(after)):
            continue
        yield finding(
            first.words[0],
            "A bus that does not come up is ignored: "
            + ("ROS starts without it" if ros is not None else "the script ends with the status of its last command"),
            advice="begin the script with set -e, or write '|| exit 1' after it",
            related=[
                *(note(run.words[0], "ignored too") for run in others[:5]),
                *([note(ros.words[0], "ROS is started here")] if ros is not None else []),
            ],
            confidence="medium",
        )


def _sets_up(robot: Robot, run: Run) -> bool:
    """Whether a command, or the script that it starts, brings a bus up."""
    if run.name == "ip":
        words = run.arguments
        return "link" in words and any(map(BUS.fullmatch, words)) and ("up" in words or "can" in words)
    if not run.words or "/" not in run.words[0]:
        return False
    path = run.text(run.words[0])
    named = [each for each in robot.tree.named(path.rpartition("/")[2]) if path.endswith(".sh")]
    script = robot.tree.read(named[0], judged=False) if len(named) == 1 else None
    return script is not None and SETS_UP.search(script.text) is not None


def _starts_ros(run: Run, source: Source) -> bool:
    """Whether a command is ``ros2 launch`` or ``ros2 run``, or an array that holds one."""
    if run.name == "ros2":
        return run.arguments[:1] in (["launch"], ["run"])
    array = ARRAY.fullmatch(run.words[0]) if run.words else None
    return (
        array is not None
        and re.search(rf"\b{re.escape(array[1])}=\(\s*ros2\s+(?:launch|run)\b", source.text) is not None
    )


def _goes_on(after: list[Run]) -> bool:
    """Whether other commands follow, so that their result is that of the script."""
    return any(run.name not in DESCRIBING for run in after)
