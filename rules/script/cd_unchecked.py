"""A script deletes everything in a folder that it may not have entered.

## What it finds
`rm -r` of `*`, `./*` or `.`, or `find . ... -delete`, after a `cd` whose failure nothing notices: no `set -e`, no `||`
and no `&&`.

## Why it matters on a robot
Where the folder is missing or named otherwise, `cd` fails, the script goes on, and deletes what is in the folder in
which it was started: the home of the user, or `/` in a service.

## Bad
```sh
cd "$HOME/recordings"
rm -rf *
```

## Good
```sh
cd "$HOME/recordings" || exit 1
rm -rf -- *
```

## When to ignore it
When the folder is surely there.

## References
- bash(1), "set -e"
- https://www.shellcheck.net/wiki/SC2164
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import shell_blocks
from bringup_lint.api.shell import unwrapped

ALL = ("*", "./*", ".", "./")
RECURSIVE = regex(r"-[a-zA-Z]*[rR][a-zA-Z]*|--recursive")
STRICT = regex(r"\bset -\w*e|\berrexit\b|^#![^\n]* -\w*e", re.M)


@rule("warning", symptoms=["cd: *: No such file or directory"])
def cd_unchecked(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and "cd " in source.text and not STRICT.search(source.text):
            yield from _of(shell_blocks(source))


def _of(blocks: tuple[Block, ...]) -> Iterator[Finding]:
    entered: Located | None = None
    for block in blocks:
        command = block.command
        if command is not None and command.name in ("cd", "pushd"):
            checked = command.ends in ("||", "&&") or len(command.words) < 2
            entered = None if checked else command.words[1]
        deleted = _deleted(command) if command is not None and entered is not None else None
        if deleted is not None and entered is not None:
            yield finding(
                deleted,
                f"Where there is no {entered}, this deletes what is in the folder in which the script was started",
                advice="write 'cd FOLDER || exit 1', or name the folder here",
                related=[note(entered, "a failure of this cd is not noticed")],
            )
            entered = None
        for body in block.bodies:
            yield from _of(body)


def _deleted(command: Command) -> Located | None:
    words = unwrapped(command.words)
    if not words:
        return None
    if words[0] == "rm" and any(map(RECURSIVE.fullmatch, words)):
        return next((word for word in words[1:] if word in ALL), None)
    return words[0] if words[0] == "find" and words[1:2] == (".",) and "-delete" in words else None
