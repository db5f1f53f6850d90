"""The number of a redirection is an argument of the command.

## What it finds
`2&> FILE` and `1&> FILE`, where the digit touches the operator: `&>` takes no number. Not behind commands whose
argument may be a number, such as `echo`, `sleep`, `exit` and `kill`, nor behind an option of one letter or a number.

## Why it matters on a robot
The command gets 2 as its last argument. `ls /dev/ttyUSB* 2&> /dev/null` fails also when there is a device, because
there is no file called 2.

## Bad
```sh
if ls /dev/ttyUSB* 2&> /dev/null; then ros2 launch heron base.launch.py; fi
```

## Good
```sh
if ls /dev/ttyUSB* &> /dev/null; then ros2 launch heron base.launch.py; fi
```

## When to ignore it
When the number is meant for the command: write a blank before `&>`.

## References
- bash(1), "Redirecting Standard Output and Standard Error"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import every_command

NUMBERED = (
    "echo",
    "printf",
    "sleep",
    "exit",
    "return",
    "kill",
    "shift",
    "seq",
    "wait",
    "test",
    "[",
    "break",
    "head",
    "tail",
    "raspi-config",
    "timeout",
)
"""Commands whose last argument may be a number."""


VALUED = regex(r"-[a-zA-Z]|\d+|0x[\da-fA-F]+")
"""An option, or a number, that a number may follow."""


@rule("warning", symptoms=["cannot access '2': No such file or directory"])
def descriptor_as_argument(robot: Robot) -> Iterator[Finding]:
    for command in every_command(robot.runners):
        last = command.words[-1] if len(command.words) > 1 else None
        if last is None or last not in ("1", "2") or command.name in NUMBERED or VALUED.fullmatch(command.words[-2]):
            continue
        if last.span.source.text.startswith("&>", last.span.end):
            yield finding(
                last,
                f"&> takes no number: {last} is an argument of {command.name}",
                advice="write &> alone, or 2> for the errors",
            )
