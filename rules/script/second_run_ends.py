"""A set-up script ends in an error when it is run again.

## What it finds
In a script under `set -e`, outside of branches and loops, a command that fails when what it makes is there already:
`rosdep init`, `groupadd` and `useradd`, `mkdir` without `-p` and `ln -s` without `-f` for a path that is known.

An info for users and groups. Silent where the script removes the path or a folder above it, asks for one of them, or
ends early where some file is there; in functions that are called under a condition; in scripts that build an image or
set up a development container; and for temporary folders.

## Why it matters on a robot
Set-up scripts are run again: after a step that failed, after an update, for the next user. The second run ends at this
command, and everything after it is never done: no packages, no build, no service.

## Bad
```sh
set -e
sudo rosdep init
rosdep update
```

## Good
```sh
set -e
[ -e /etc/ros/rosdep/sources.list.d/20-default.list ] || sudo rosdep init
rosdep update
```

## When to ignore it
When the script is only for a robot on which nothing is installed yet, and is never run twice.

## References
- https://github.com/ros-infrastructure/rosdep: "ERROR: default sources list file already exists"
- bash(1), "SHELL BUILTIN COMMANDS", set -e
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import ended_by_failure
from bringup_lint.api.shell import is_inverted
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import shell_blocks
from bringup_lint.api.shell import unwrapped

MOST = 40
"""Parts of a path that are looked at."""
HAS_COMMAND = regex(r"\brosdep[ \t]+init\b|\b(?:groupadd|useradd|mkdir|ln)[ \t]")
KNOWN = regex(r"(?:/|~/|\$HOME/|\$\{HOME\}/)(?!tmp/|run/|dev/shm/|proc/|sys/)[\w./@+-]+")
ASKS = regex(r"(?:\[|\b(?:test|rm|rmdir|getent|id|grep|unlink|userdel|groupdel|ls)\b)([^\n]*)")
NAME = regex(r"[\w.@+-]+")
FOLDER = regex(r"[ \t\"']((?:~|\$HOME|\$\{HOME\})?[\w./@+-]+)")
IS_THERE = regex(r"-[edfhLrsx]")
FOUND_BY = ("which", "type", "dpkg", "pgrep", "id", "getent", "grep")
"""Programs that are asked whether something was done before."""
ENDS = ("exit", "return", "exec")
FILE = regex(r"\.\w+\Z|/s?bin/[^/]+\Z")
"""What is no folder; a link to a folder gets the next link inside."""
ADVICE = {
    "rosdep": "write [ -e /etc/ros/rosdep/sources.list.d/20-default.list ] || before it",
    "groupadd": "write groupadd -f",
    "useradd": "write id NAME || before it",
    "mkdir": "write mkdir -p",
    "ln": "write ln -sfn",
}


@rule("warning", symptoms=["ERROR: default sources list file already exists"])
def second_run_ends(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or not source.matches(HAS_COMMAND):
            continue
        if robot.scripts.is_for_image(source):
            continue
        always = list(_always(shell_blocks(source)))
        if any(map(_ends_early, always)):
            continue
        lists = set(map(id, always))
        asked = _asked_for(source.text)
        for statement in ended_by_failure(source):
            command = statement.block.command if id(statement.among) in lists else None
            found = _made(command) if command is not None and statement.after not in ("&&", "||", "|") else None
            if found is not None and not _is_asked_for(asked, found[1]):
                if robot.scripts.sets_up_image(source):
                    break
                program, made = found
                yield finding(
                    made,
                    f"This fails when it is there already: under set -e the second run of {source.basename} ends here",
                    advice=ADVICE[program],
                    severity="info" if program in ("groupadd", "useradd") else None,
                )


def _always(statements: tuple[Block, ...]) -> Iterator[tuple[Block, ...]]:
    """The lists of statements that run each time: that of the script, and of the functions that it calls there."""
    functions = {block.name: block.bodies[0] for block in statements if block.kind == "function"}
    left = [statements]
    while left:
        listed = left.pop()
        yield listed
        for before, block in zip((None, *listed), listed, strict=False):
            is_alone = before is None or before.command is None or before.command.ends not in ("&&", "||")
            if block.command is not None and is_alone and block.command.name in functions:
                left.append(functions.pop(block.command.name))


def _ends_early(statements: tuple[Block, ...]) -> bool:
    """Whether the script ends under the condition that something is there."""
    for at, block in enumerate(statements):
        asked = block.condition if block.kind == "branches" else statements[at : at + 1]
        then = block.bodies[0] if block.kind == "branches" and block.bodies else statements[at + 1 : at + 2]
        if any(map(_asks, asked)) and any(name in ENDS for name in _named(then)):
            return True
    return False


def _asks(block: Block) -> bool:
    command = block.command
    if command is None or command.ends == "||" or "!" in command.words or is_inverted(command):
        return False
    return command.name in FOUND_BY or "-v" in command.words[1:2] or any(map(IS_THERE.fullmatch, command.words))


def _named(blocks: tuple[Block, ...]) -> Iterator[str]:
    for block in blocks:
        if block.command is not None:
            yield block.command.name
        for body in block.bodies:
            yield from _named(body)


def _made(command: Command) -> tuple[str, Located] | None:
    """The program of a command that fails where something is there already, and what this is."""
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    options = [word for word in words[1:] if word.startswith("-")]
    plain = [word for word in words[1:] if not word.startswith("-")]
    letters = "".join(options)
    if name == "rosdep":
        return (name, words[0]) if plain[:1] == ["init"] else None
    if name in ("groupadd", "useradd"):
        return (name, words[-1]) if "f" not in letters and plain and words[-1].isidentifier() else None
    if name == "mkdir":
        return (name, plain[-1]) if "p" not in letters and len(plain) == 1 and KNOWN.fullmatch(plain[0]) else None
    if name == "ln" and "s" in letters and "f" not in letters and len(plain) == 2 and FILE.search(plain[0]):
        return (name, plain[1]) if KNOWN.fullmatch(plain[1]) and not plain[1].endswith("/") else None
    return None


def _asked_for(text: str) -> set[str]:
    """The names and folders that a script looks for, or removes, the names with and without their suffixes."""
    rests = [found[1] for found in ASKS.finditer(text)]
    words = {word for rest in rests for word in NAME.findall(rest)}
    folders = {path.removesuffix("/") for rest in rests for path in FOLDER.findall(rest)}
    return words | folders | {word.partition(".")[0] for word in words} | {word.rpartition(".")[0] for word in words}


def _is_asked_for(asked: set[str], made: Located) -> bool:
    """Whether the script looks for what it makes, or removes it, or a folder above it."""
    if ("20-default" if made == "rosdep" else made.rpartition("/")[2]) in asked:
        return True
    parts = made.split("/", MOST)
    return any("/".join(parts[:end]) in asked for end in range(3 if made.startswith("/") else 2, len(parts)))
