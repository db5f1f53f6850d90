"""`exit` is an argument of the command before it.

## What it finds
`exit` or `return` with a number, without quotes, as the last words of `echo`, `printf` or a function of the same
script: the separator before it is missing.

## Why it matters on a robot
The message appears, and the script goes on: `-h` prints the help and then starts the robot, a failed check is followed
by the step that it was to prevent.

## Bad
```sh
[ -e /dev/rover ] || { echo "no base" exit 1; }
```

## Good
```sh
[ -e /dev/rover ] || { echo "no base"; exit 1; }
```

## When to ignore it
When the words are really to be printed: then quote them.

## References
- bash(1), "Lists"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import shell_commands

PRINTS = ("echo", "printf")
ENDS = ("exit", "return")
STATUS = regex(r"\d{1,3}|\$\?|-1")
FUNCTION = regex(r"^[ \t]*(?:function[ \t]+)?(?P<name>[A-Za-z_]\w*)[ \t]*\([ \t]*\)", re.M)
ARGUMENT = regex(r"\$(?:[@*#1-9]|\{[@*#1-9])|\bshift\b")
QUOTES = ("'", '"')
LEAST = 3


@rule("error", silent="the words are printed, or given to the function")
def exit_swallowed(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or not any(word in source.text for word in ENDS):
            continue
        names = {*_without_arguments(source.text), *PRINTS}
        for command in shell_commands(source):
            if command.name in names and _swallows(command):
                word = command.words[-2]
                yield finding(
                    word,
                    f"'{word} {command.words[-1]}' is an argument of {command.words[0]}: the script goes on here",
                    advice=f"write ; before {word}",
                )


def _without_arguments(text: str) -> Iterator[str]:
    """The functions of a script that read none of their arguments."""
    for match in FUNCTION.finditer(text):
        end = text.find("\n}", match.end())
        if not ARGUMENT.search(text, match.end(), end if end != -1 else len(text)):
            yield match["name"]


def _swallows(command: Command) -> bool:
    """Whether the last words are a command of their own without a separator."""
    words = command.words
    if len(words) < LEAST or words[-2] not in ENDS or words[-2].span.text != words[-2]:
        return False
    if command.name in PRINTS:
        if words[-3].span.text[-1:] not in QUOTES or "%" in words[1] or words[-1] == "$?":
            return False
    elif len(words) != LEAST or words[-2] != "exit":
        return False
    return STATUS.fullmatch(words[-1]) is not None and words[-1].span.text == words[-1]
