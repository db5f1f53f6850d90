"""A script deletes everything in a folder that it may not have entered.

## What it finds
`rm -r` of `*` or `./*`, or `find . ... -delete`, after a `cd` whose failure nothing notices: no `set -e`, no `||`, no
`&&` and no test. Silent where the script makes the folder or tests for it, and for folders that are always there.

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
from itertools import islice

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import STRICT
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import shell_blocks
from bringup_lint.api.shell import unwrapped

ALL = ("*", "./*")
RECURSIVE = regex(r"-[a-zA-Z]*[rR][a-zA-Z]*|--recursive")
CHECKED = regex(rf"{STRICT}|\btrap\b[^\n]{{0,200}}\bERR\b", re.M)
SURE = regex(r"[./~-]*|/(?:tmp|home|var|var/log|etc|opt|root|usr)/?|\$\{?HOME\}?/?|.*[`*(%].*", re.S)
"""Folders that are there, and those that a command finds."""
TESTS = ("[", "[[", "test")
MAKES = regex(r"(?:\b(?:mkdir|clone|test|for|install)|\[)[ \t]")
ASKED = regex(r"=[^\n]{0,200}[`(%]")
NEAR = 200
"""Characters before a name."""
MENTIONS = 100
"""Places of a name that are looked at."""


@rule("warning", symptoms=["cd: *: No such file or directory"])
def cd_unchecked(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and not CHECKED.search(source.text):
            yield from _of(source, shell_blocks(source))


def _of(source: Source, blocks: tuple[Block, ...]) -> Iterator[Finding]:
    entered: Located | None = None
    for block in blocks:
        command = block.command
        if command is None or command.name in TESTS:
            entered = None
        elif command.name in ("cd", "pushd"):
            entered = _entered(source, command)
        elif entered is not None and (deleted := _deleted(command)) is not None:
            yield finding(
                deleted,
                f"Where there is no {entered}, this deletes what is in the folder in which the script was started",
                advice="write 'cd FOLDER || exit 1', or name the folder here",
                related=[note(entered, "a failure of this cd is not noticed")],
            )
            entered = None
        for body in block.bodies:
            yield from _of(source, body)


def _entered(source: Source, command: Command) -> Located | None:
    """The folder that a command enters, where it may fail and nothing notices."""
    folder = next((word for word in command.words[1:] if not word.startswith("-")), None)
    if folder is None or command.ends in ("||", "&&") or SURE.fullmatch(folder):
        return None
    name = folder.rstrip("/").rpartition("/")[2].strip("${}")
    return None if name and _is_made(source, name) else folder


def _is_made(source: Source, name: str) -> bool:
    """Whether the script makes or looks for a folder, or asks a command for it, a little before its name."""
    for match in islice(re.finditer(rf"\b{re.escape(name)}\b", source.text), MENTIONS):
        line = source.text.rfind("\n", 0, match.start()) + 1
        before = source.text[max(line, match.start() - NEAR) : match.start()]
        if MAKES.search(before) or ASKED.match(source.text, match.end()):
            return True
    return False


def _deleted(command: Command) -> Located | None:
    words = unwrapped(command.words)
    if not words:
        return None
    if words[0] == "rm" and any(map(RECURSIVE.fullmatch, words)):
        return next((word for word in words[1:] if word in ALL), None)
    return words[0] if words[0] == "find" and words[1:2] == (".",) and "-delete" in words else None
