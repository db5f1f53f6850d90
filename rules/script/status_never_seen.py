"""Under `set -e` a script asks for a failure that has already ended it.

## What it finds
After `set -e` (or `#!/bin/bash -e`), outside of conditions:

- `$?` right after a command, where the branch for a failure is never reached;
- a test whether NAME is empty after `NAME=$(which PROGRAM)`, and with `command -v`, `pgrep`, `pidof`, `grep` and
  `getent`, which fail where they find nothing, with `ls`, `dpkg` and the like whose errors go to `/dev/null`, and with
  `systemctl is-active`. With `pipefail` one of them anywhere in a pipe;
- a default, `NAME=${NAME:-value}`, after such a `NAME=$(...)`, also where it calls a function of the script that is
  one such pipe.

A warning where the branch does something, and where the command before prints nothing itself. Info where the branch
only prints a message, or cleans up, and ends the script, and in scripts that run while an image is built, whose failure
is seen there and then. Silent where it only ends it, and where the script reads another one that has `set +e`.

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
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import Statement
from bringup_lint.api.shell import commands
from bringup_lint.api.shell import ended_by_failure
from bringup_lint.api.shell import is_inverted
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import shell_blocks
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.shell import substitutions
from bringup_lint.api.shell import unwrapped

TESTS = ("[", "[[", "test")
SAYS = frozenset("echo printf cat exit return cd popd die".split())
CLEANS = frozenset("rm rmdir umount popd cd".split())
REPORTS = frozenset("echo printf print log err error warn warning info panic fail fatal usage help msg message".split())
"""Words in the names of functions that only say something."""
QUIET = ("exit", "return", "cd", "popd")
SEARCHES = ("which", "pgrep", "pidof", "grep", "egrep", "fgrep", "getent")
QUERIES = ("command -v", "type -p", "type -P", "systemctl is-active", "systemctl is-enabled")
FAILING = ("ls ", "dpkg ", "dpkg-query ", "rospack find", "ros2 pkg", "docker inspect")
"""What says an error where nothing is there."""
FOR_NOTHING = {"": True, "inactive": True, "disabled": True, "failed": True, "active": False, "enabled": False}
"""Values that a variable is compared with, and whether it has them only where the command failed."""
PIPEFAIL = regex(r"^[ \t]*set[ \t][^\n#]*\bpipefail\b", re.M, "pipefail")
OFF = regex(r"\bset[ \t]+\+\w{0,8}e")
SILENT = ("[", "[[", "test", "which", "pgrep", "pidof")
NO_STATUS = ("local", "export", "declare", "readonly", "typeset", "set", "echo", "printf", "trap", "true", ":", "exec")
STATUS = ("$?", "${?}")
FOUND = regex(r"(?P<name>\w+)=")
ASSIGNED = regex(r"(?P<name>\w+)=\$\{?\?\}?")
ENDS = ("", "\n", ";")
NEAR = 12
"""Statements between an assignment and the test."""


@rule("warning", silent="the script ends at the command before, with its message alone")
def status_never_seen(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template:
            pipefail = source.matches(PIPEFAIL)
            statements = list(ended_by_failure(source))
            searches = _searches(source, pipefail) if statements else frozenset()
            for statement in statements:
                yield from _dead(robot, source, statement, pipefail)
                yield from _dead_default(robot, source, statement, pipefail, searches)


def _searches(source: Source, pipefail: bool) -> frozenset[str]:
    """The functions of a script that are one pipe which fails where it finds nothing."""
    found = (block for block in shell_blocks(source) if block.kind == "function")
    return frozenset(block.name for block in found if _is_search_pipe(block.bodies[0], pipefail))


def _is_search_pipe(blocks: tuple[Block, ...], pipefail: bool) -> bool:
    piped = [block.command for block in blocks if block.command is not None]
    if (
        not piped
        or len(piped) != len(blocks)
        or any(each.ends != "|" for each in piped[:-1])
        or piped[-1].ends not in ENDS
    ):
        return False
    return any(_is_search(each) for each in (piped if pipefail else piped[-1:]))


def _dead_default(
    robot: Robot, source: Source, statement: Statement, pipefail: bool, searches: frozenset[str]
) -> Iterator[Finding]:
    """A default for what was not found, which is never reached."""
    command = statement.block.command
    if command is None or command.words or len(command.assignments) != 1 or statement.after in ("&&", "||", "|"):
        return
    found = FOUND.match(command.assignments[0])
    if found is None or not _finds_nothing(command.assignments[0], found.end(), pipefail, searches):
        return
    default = next(_defaults(statement.among[statement.at + 1 : statement.at + 1 + NEAR], found["name"]), None)
    if default is not None and not _is_turned_off(robot, source):
        yield finding(
            default,
            "The script has set -e: where nothing is found, it ends before this default",
            advice="write || true behind the command in $(...)",
            related=[note(command.assignments[0], "a failure ends the script here")],
            severity="info" if robot.scripts.sets_up_image(source) else None,
        )


def _defaults(after: tuple[Block, ...], name: str) -> Iterator[Located]:
    """The assignments that give a variable its own value or a default."""
    for block in after:
        words = block.command.assignments if block.command is not None and not block.command.words else ()
        yield from (word for word in words if word.startswith((f"{name}=${{{name}:-", f"{name}=${{{name}-")))


def _is_turned_off(robot: Robot, source: Source) -> bool:
    """Whether a script that this one reads has ``set +e``, maybe in a function."""
    read = source.once(OFF, lambda: _read(source))
    return bool(read) and any(each.basename in read and OFF.search(each.text) for each in robot.of_kind("shell-script"))


def _read(source: Source) -> frozenset[str]:
    """The names of the scripts that a script reads."""
    reads = (each for each in shell_commands(source) if each.name in (".", "source") and each.words[1:])
    return frozenset(each.words[1].rpartition("/")[2] for each in reads)


def _dead(robot: Robot, source: Source, statement: Statement, pipefail: bool) -> Iterator[Finding]:
    command = statement.block.command
    if command is None or statement.after in ("&&", "||"):
        return
    following = statement.among[statement.at + 1 : statement.at + 1 + NEAR]
    dead = _asked_status(following[:2]) if command.words and command.name not in NO_STATUS else None
    if dead is None and not command.words and statement.after != "|":
        dead = _asked_text(command, following, pipefail)
    if dead is None:
        return
    where, body = dead
    first = (*command.words, *command.assignments)[0]
    named = [each.name for each in _all(body)]
    acts = [name for name in named if name not in SAYS and REPORTS.isdisjoint(name.split("_"))]
    only_cleans = "exit" in named and CLEANS.issuperset(acts)
    if all(name in QUIET for name in named) or _is_turned_off(robot, source):
        return
    is_found_late = (acts and not only_cleans) or not command.words or _is_silent(command)
    yield finding(
        where,
        f"The script has set -e: {_told(bool(acts), bool(command.words))}",
        advice="write 'if ! COMMAND; then'" if command.words else "write || true behind the command in $(...)",
        related=[note(first, "a failure ends the script here")],
        severity="warning" if is_found_late and not robot.scripts.sets_up_image(source) else "info",
    )


def _told(acts: bool, has_words: bool) -> str:
    if acts:
        return "where this command fails, it ends there, and what is meant for this case never runs"
    if has_words:
        return "where the command before fails, it ends there, and this message is never printed"
    return "where nothing is found, it ends there without a word, and this message is never printed"


def _is_silent(command: Command) -> bool:
    """Whether a command prints nothing when it fails."""
    words = set(command.words)
    return (
        command.name in SILENT
        or (command.name in ("grep", "cmp") and bool(words & {"-q", "-s"}))
        or command.hides_errors
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


def _asked_text(command: Command, after: tuple[Block, ...], pipefail: bool) -> tuple[Located, tuple[Block, ...]] | None:
    """The test whether nothing was found, with what is meant for this."""
    found = FOUND.match(command.assignments[0]) if len(command.assignments) == 1 else None
    if found is None or not _finds_nothing(command.assignments[0], found.end(), pipefail):
        return None
    name = found["name"]
    for at, block in enumerate(after):
        for each in _all((block,)):
            if any(word.startswith((f"{name}=", f"{name}+=")) for word in each.assignments):
                return None
        test = _test(block)
        if test is not None and any(f"${name}" in word or f"${{{name}}}" in word for word in test.words):
            asked = _asks_for_nothing(test.words[1:], name)
            body = _branch(after[at:], asked[1]) if asked is not None else ()
            return (asked[0], body) if asked is not None and body else None
    return None


def _finds_nothing(word: Located, start: int, pipefail: bool, searches: frozenset[str] = frozenset()) -> bool:
    """Whether the value is that of a search which fails where it finds nothing."""
    texts = list(substitutions(word))
    if len(texts) != 1 or word[start:] not in (f"$({texts[0]})", f"`{texts[0]}`"):
        return False
    inner = commands(texts[0])
    if not inner or any(each.depth or each.ends in ("||", "&&", ";") for each in inner):
        return False
    return any(_is_search(each) or each.name in searches for each in (inner if pipefail else inner[-1:]))


def _is_search(command: Command) -> bool:
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    if name in SEARCHES:
        return True
    asked = " ".join([name, *(word for word in words[1:3] if not word.startswith("--"))])
    return asked.startswith(QUERIES) or (command.hides_errors and asked.startswith(FAILING))


def _asks_for_nothing(words: tuple[Located, ...], name: str) -> tuple[Located, bool] | None:
    """The variable in a test whether it is empty, and whether the test holds where it is."""
    words = tuple(word for word in words if word not in ("]", "]]"))
    is_empty = True
    if words[:1] == ("!",):
        words, is_empty = words[1:], False
    names = (f"${name}", f"${{{name}}}")
    if len(words) == 1 and words[0] in names:
        return words[0], not is_empty
    if len(words) == 2 and words[0] in ("-z", "-n") and words[1] in names:
        return words[1], is_empty == (words[0] == "-z")
    if len(words) == 3 and words[0] in names and words[1] in ("=", "==", "!=") and words[2] in FOR_NOTHING:
        return words[0], is_empty == ((words[1] != "!=") == FOR_NOTHING[words[2]])
    return None


def _test(block: Block) -> Command | None:
    """A single test: the condition of a branch, or before `&&` and `||`."""
    if block.kind == "branches" and block.items == () and block.condition:
        command = block.condition[0].command
        is_single = command is not None and command.ends in ENDS
    else:
        command = block.command
        is_single = command is not None and command.ends in ("&&", "||")
    is_test = command is not None and command.name in TESTS and is_single and not is_inverted(command)
    return command if is_test else None


def _branch(blocks: tuple[Block, ...], is_failure: bool) -> tuple[Block, ...]:
    """What runs where the test holds, or where it does not."""
    block = blocks[0]
    if block.command is None:
        return block.bodies[0] if is_failure else block.bodies[1] if len(block.bodies) > 1 else ()
    return blocks[1:2] if (block.command.ends == "&&") == is_failure else ()
