"""Under `set -e` a script asks for a failure that has already ended it.

## What it finds
After `set -e` (or `#!/bin/bash -e`), outside of conditions:

- `$?` right after a command, where the branch for a failure is never reached;
- a test whether NAME is empty after `NAME=$(which PROGRAM)`, and with `command -v`, `pgrep`, `pidof` and `grep`, which
  fail where they find nothing.

A warning where the branch does something, and info where it only prints a message and ends the script. Silent where it
only ends it.

## Why it matters on a robot
The script ends at the command itself. What is meant for the robot without the program or the process, such as its
installation, never runs, and nobody sees the message that says what is missing.

## Bad
```sh
set -e
CANDUMP=$(command -v candump)
if [ -z "$CANDUMP" ]; then apt-get install -y can-utils; fi
```

## Good
```sh
set -e
CANDUMP=$(command -v candump || true)
if [ -z "$CANDUMP" ]; then apt-get install -y can-utils; fi
```

## When to ignore it
When the script is only read by others, under `set +e`.

## References
- bash(1), "SHELL BUILTIN COMMANDS", set -e
"""

import re
from collections.abc import Iterator

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
from bringup_lint.api.shell import commands
from bringup_lint.api.shell import shell_blocks
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.shell import with_inner

ERREXIT = regex(STRICT, re.M)
SHEBANG = regex(r"#!\S+[ \t]+-\w*e\w*[ \t]*(?:\n|\Z)")
ON = regex(r"-[a-zA-Z]*e[a-zA-Z]*")
OFF = regex(r"\+[a-zA-Z]*e[a-zA-Z]*")
TESTS = ("[", "[[", "test")
SAYS = frozenset("echo printf cat exit return cd popd die".split())
REPORTS = frozenset("print log err error warn warning info panic fail fatal usage help msg message".split())
"""Words in the names of functions that only say something."""
QUIET = ("exit", "return", "cd", "popd")
SEARCHES = ("which", "pgrep", "pidof", "grep", "egrep", "fgrep")
NO_STATUS = ("local", "export", "declare", "readonly", "typeset", "set", "echo", "printf", "trap", "true", ":", "exec")
TAKE_WORDS = (*NO_STATUS, "unset", "systemctl", "service")
"""Commands whose arguments are no commands that they run under a condition."""
STATUS = ("$?", "${?}")
FOUND = regex(r"(?P<name>\w+)=(?:\$\((?P<dollar>[^()]*)\)|`(?P<tick>[^`]*)`)")
ASSIGNED = regex(r"(?P<name>\w+)=\$\{?\?\}?")
ENDS = ("", "\n", ";")
NEAR = 3
"""Statements between an assignment and the test."""


@rule("warning", silent="the script ends at the command before, with its message alone")
def status_never_seen(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and ERREXIT.search(source.text):
            yield from _of(source)


def _of(source: Source) -> Iterator[Finding]:
    blocks = shell_blocks(source)
    functions = {block.name for block in blocks if block.kind == "function"}
    soft = set(_softly(blocks))
    are_plain = functions.isdisjoint((*soft, *_handed_on(source))) and not any("$" in name for name in soft)
    strict = SHEBANG.match(source.text) is not None
    for at, block in enumerate(blocks):
        if block.command is not None and block.command.name == "set":
            strict = _after_set(block.command, strict)
        elif block.kind == "function":
            if are_plain and "set +" not in source.text:
                yield from _in_list(block.bodies[0])
        elif strict and not _turns(block):
            yield from _at(blocks, at)


def _softly(blocks: tuple[Block, ...], *, soft: bool = False) -> Iterator[str]:
    """The commands under whose names `set -e` has no effect: in conditions, and before `&&` and `||`."""
    for block in blocks:
        if block.command is not None and (soft or block.command.ends in ("&&", "||") or _is_inverted(block.command)):
            yield block.command.name
        yield from _softly(block.condition, soft=True)
        for body in block.bodies:
            yield from _softly(body, soft=soft or block.ends in ("&&", "||"))


def _handed_on(source: Source) -> Iterator[str]:
    """Words that another command may call in a condition, and the commands in `$(...)`, where bash has no `set -e`."""
    outer = shell_commands(source)
    spans = {command.words[0].span for command in outer if command.words}
    for command in with_inner(outer):
        if command.words and command.words[0].span not in spans:
            yield command.name
        if command.name not in TAKE_WORDS:
            yield from command.words[1:]


def _is_inverted(command: Command) -> bool:
    if not command.words:
        return False
    span = command.words[0].span
    return span.source.line_before(span.start).rstrip().endswith("!")


def _after_set(command: Command, strict: bool) -> bool:
    words = command.words[1:]
    if any(map(OFF.fullmatch, words)) or ("+o" in words and "errexit" in words):
        return False
    return strict or any(map(ON.fullmatch, words)) or ("-o" in words and "errexit" in words)


def _turns(block: Block) -> bool:
    """Whether `set` is called within."""
    inner = (*block.condition, *(each for body in block.bodies for each in body))
    return any((each.command is not None and each.command.name == "set") or _turns(each) for each in inner)


def _in_list(blocks: tuple[Block, ...]) -> Iterator[Finding]:
    for at in range(len(blocks)):
        yield from _at(blocks, at)


def _at(blocks: tuple[Block, ...], at: int) -> Iterator[Finding]:
    block = blocks[at]
    if block.ends not in ("&&", "||"):
        for body in block.bodies:
            yield from _in_list(body)
    command = block.command
    before = blocks[at - 1].command if at else None
    ended = blocks[at - 1].ends if at and before is None else before.ends if before is not None else "\n"
    if command is None or command.ends not in ENDS or ended in ("&&", "||") or _is_inverted(command):
        return
    dead = _asked_status(blocks[at + 1 : at + 3]) if command.words and command.name not in NO_STATUS else None
    if dead is None and not command.words and ended != "|":
        dead = _asked_text(command, blocks[at + 1 : at + 1 + NEAR])
    if dead is None:
        return
    where, body = dead
    first = (*command.words, *command.assignments)[0]
    named = [each.name for each in _all(body)]
    acts = [name for name in named if name not in SAYS and REPORTS.isdisjoint(name.split("_"))]
    if all(name in QUIET for name in named):
        return
    yield finding(
        where,
        "The script has set -e: where this command fails, it ends there, and what is meant for this case never runs"
        if acts
        else "The script has set -e: where the command before fails, it ends there, and this message is never printed",
        advice="write 'if ! COMMAND; then'" if command.words else "write || true behind the command in $(...)",
        related=[note(first, "a failure ends the script here")],
        severity="warning" if acts else "info",
    )


def _all(blocks: tuple[Block, ...]) -> Iterator[Command]:
    for block in blocks:
        if block.command is not None:
            yield block.command
        for body in block.bodies:
            yield from _all(body)


def _asked_status(after: tuple[Block, ...]) -> tuple[Located, tuple[Block, ...]] | None:
    """The test of the status, with what is meant for a failure."""
    if not after:
        return None
    names: tuple[str, ...] = STATUS
    kept = after[0].command
    if kept is not None and not kept.words and len(kept.assignments) == 1:
        assigned = ASSIGNED.fullmatch(kept.assignments[0])
        if assigned is None or len(after) < 2:
            return None
        names = (f"${assigned['name']}", f"${{{assigned['name']}}}")
        after = after[1:]
    test = _test(after[0])
    if test is None or len(test.words) < 4 or test.words[1] not in names:
        return None
    operator, value = test.words[2], test.words[3]
    is_failure = (operator in ("-ne", "!=", "-gt")) == (value == "0")
    body = _branch(after, is_failure)
    return (test.words[1], body) if body else None


def _asked_text(command: Command, after: tuple[Block, ...]) -> tuple[Located, tuple[Block, ...]] | None:
    """The test whether nothing was found, with what is meant for this."""
    found = FOUND.fullmatch(command.assignments[0]) if len(command.assignments) == 1 else None
    if found is None:
        return None
    group = "dollar" if found["dollar"] is not None else "tick"
    inner = commands(command.assignments[0].part(*found.span(group)))
    if not inner or any(each.ends in ("||", "&&", ";") for each in inner):
        return None
    last = inner[-1]
    if last.name not in SEARCHES and [str(word) for word in last.words[:2]] != ["command", "-v"]:
        return None
    names = (f"${found['name']}", f"${{{found['name']}}}")
    for at, block in enumerate(after):
        test = _test(block)
        if test is not None and len(test.words) > 2 and test.words[2] in names and test.words[1] in ("-z", "-n"):
            body = _branch(after[at:], test.words[1] == "-z")
            return (test.words[2], body) if body else None
    return None


def _test(block: Block) -> Command | None:
    """A single test: the condition of a branch, or before `&&` and `||`."""
    if block.kind == "branches" and block.items == () and block.condition:
        command = block.condition[0].command
        is_single = command is not None and command.ends in ENDS
    else:
        command = block.command
        is_single = command is not None and command.ends in ("&&", "||")
    is_test = command is not None and command.name in TESTS and is_single and not _is_inverted(command)
    return command if is_test else None


def _branch(blocks: tuple[Block, ...], is_failure: bool) -> tuple[Block, ...]:
    """What runs where the test holds, or where it does not."""
    block = blocks[0]
    if block.command is None:
        return block.bodies[0] if is_failure else block.bodies[1] if len(block.bodies) > 1 else ()
    return blocks[1:2] if (block.command.ends == "&&") == is_failure else ()
