"""A script of the tree is called with fewer arguments than it uses.

## What it finds
A script of the tree that another script or a unit calls by its path with fewer arguments than it reads (`$1`, `$2`).
An error under `set -u`, which ends the script there; otherwise a warning.

Silent for a script that looks at `$#`, shifts, parses options, gives defaults (`${2:-115200}`) or tests the argument,
for arguments that a variable or a pattern may multiply, and for functions, which have arguments of their own.

## Why it matters on a robot
The argument is empty: a port is opened without its speed, a file gets half a name, and `rm -rf "$2"/*` means the whole
disk. With `set -u` the set-up ends with "$2: unbound variable".

## Bad
```sh
./set_baud.sh /dev/ttyS1          # set_baud.sh: stty -F "$1" "$2"
```

## Good
```sh
./set_baud.sh /dev/ttyS1 115200
```

## When to ignore it
When the script works with an empty argument on purpose.

## References
- POSIX, Shell Command Language, 2.5.1 Positional Parameters
"""

import posixpath
import re
from collections.abc import Iterator
from collections.abc import Sequence
from functools import cache

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import shell_blocks

HANDLED = regex(r"\$#|\$\{#|\bshift\b|\bgetopts?\b|\$[@*]|\$\{[@*]|\bBASH_ARGV\b|\bset[ \t]+--[ \t]")
"""The script sees itself how many arguments there are."""
NOUNSET = regex(
    r"^[ \t]*set[ \t]+-(?:[a-zA-Z]{0,9}u|o[ \t]+nounset|[a-zA-Z]{1,9}[ \t]+-u)|^#![^\n]{0,40}[ \t]-[a-z]{0,9}u", re.M
)
USED = regex(r"\$(?P<plain>[1-9])|\$\{(?P<braced>[1-9])\}")
FIELDS = regex(r"\bg?awk\b|\bperl\b|\bsed\b")
"""Programs with variables of these names, which a command substitution may hold."""
TESTS = ("[", "[[", "test", "case")
SHELLS = ("bash", "sh", "dash")
SEVERAL = regex(r"[*?\[]|\$[@*]|\$\{\w+\[[@*]\]|\$\(")


@rule("warning", confidence="medium", symptoms=["unbound variable", "parameter not set"])
def argument_missing(robot: Robot) -> Iterator[Finding]:
    scripts: dict[str, list[Source]] = {}
    for source in robot.of_kind("shell-script"):
        scripts.setdefault(source.basename, []).append(source)
    uses = cache(_uses)
    for caller, words in _calls(robot):
        named = scripts.get(posixpath.basename(words[0]), []) if words and _is_path(words[0]) else []
        beside = posixpath.normpath(posixpath.join(posixpath.dirname(caller.name), words[0])) if named else ""
        named = [each for each in named if each.name == beside] or named
        if len(named) != 1 or named[0] is caller or any(SEVERAL.search(word) for word in words):
            continue
        lacking = [use for number, use in sorted(uses(named[0]).items()) if number >= len(words)]
        if lacking:
            yield _finding(named[0], words, lacking)


def _calls(robot: Robot) -> Iterator[tuple[Source, Sequence[Located]]]:
    """The commands of scripts and units, from the name of what may be a script on."""
    for source in robot.of_kind("shell-script"):
        if not source.judged:
            continue
        for did in robot.scripts.done(source):
            if isinstance(did, Run) and did.words and did.command.ends != "||":
                yield source, _from_script(did.words)
    for unit in robot.units.services:
        if not unit.judged or unit.uncertain:
            continue
        for process in robot.units.processes(unit):
            if process.argv:
                yield unit.files[0].source, _from_script(process.argv)


def _from_script(words: Sequence[Located]) -> Sequence[Located]:
    return words[1:] if len(words) > 1 and program_name(words[0]) in SHELLS else words


def _is_path(word: Located) -> bool:
    return "/" in word and word.endswith((".sh", ".bash"))


def _finding(script: Source, words: Sequence[Located], lacking: list[Located]) -> Finding:
    stops = NOUNSET.search(script.text) is not None
    given = len(words) - 1
    count = "no argument" if not given else "one argument" if given == 1 else f"{given} arguments"
    return finding(
        words[0],
        f"{script.basename} gets {count} and uses {lacking[0]}: "
        + ("it ends with 'unbound variable'" if stops else "it goes on with an empty one"),
        advice="give the argument, or a default in the script: ${N:-...}",
        related=[note(each, "used here") for each in lacking[:5]],
        severity="error" if stops else None,
    )


def _uses(script: Source) -> dict[int, Located]:
    """The arguments that a script surely reads, with the first word that does."""
    if HANDLED.search(script.text) or script.template:
        return {}
    found: dict[int, Located] = {}
    tested: set[int] = set()
    for block in _top(shell_blocks(script)):
        command = block.command
        if command is None:
            continue
        for word in (*command.words, *command.assignments):
            for number in _numbers(word):
                found.setdefault(number, word)
                if command.name in TESTS or command.ends in ("||", "&&"):
                    tested.add(number)
    guarded = {
        int(each)
        for each in re.findall(r"\$\{(\d)[:=?+-]|\bcase[ \t]+\"?\$\{?(\d)", script.text)
        for each in each
        if each
    }
    return {number: word for number, word in found.items() if number not in tested | guarded}


def _numbers(word: Located) -> Iterator[int]:
    if FIELDS.search(word):
        return
    parts = word.stretches() if hasattr(word, "stretches") else [(word, "")]
    for part, quote in parts:
        if quote != "'":
            yield from (int(match["plain"] or match["braced"]) for match in USED.finditer(part))


def _top(blocks: Sequence[Block]) -> Iterator[Block]:
    """The statements that run in any case: not those of functions and branches."""
    for block in blocks:
        yield block
        if block.kind == "group":
            yield from _top(block.bodies[0])
        elif block.kind == "branches":
            yield from (each for each in block.condition)
