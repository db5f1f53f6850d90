"""A set-up script ends in an error when it is run again.

## What it finds
In a script under `set -e`, outside of branches and loops, a command that fails when what it makes is there already:
`rosdep init`, `groupadd` and `useradd`, `mkdir` without `-p` and `ln -s` without `-f` for a path that is known,
`git clone` into a folder, `docker network create`, `ip link add` and `dkms add`. Also `mv` of a file of the checkout,
which is no longer there the second time.

An info for users and groups, and for folders, links and `rosdep init` in a script of which nothing says that it runs
again: nothing of the tree starts it, and it is not called after an update, a deployment or a start. Silent where the
script removes the path or a folder above it, asks for one of them, or ends early where some file is there; in functions
that are called under a condition; in scripts that build an image or set up a development container; and for temporary
folders. A clone is not reported in a script that asks for a folder or removes one that it enters. An info as well
where the script does nothing after it but to the interface that is there.

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

import posixpath
import re
from collections import Counter
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
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
HAS_COMMAND = regex(
    r"\brosdep[ \t]+init\b|\b(?:groupadd|useradd|mkdir|ln|mv)[ \t]"
    r"|\b(?:git[ \t]+clone|dkms[ \t]+add|link[ \t]+add|network[ \t]+create)[ \t]"
)
KNOWN = regex(r"(?:/|~/|\$HOME/|\$\{HOME\}/)(?!tmp/|run/|dev/shm/|proc/|sys/)[\w./@+-]+")
ASKS = regex(
    r"(?:(?<!\S)\[|\b(?:test|rm|rmdir|getent|id|grep|unlink|userdel|groupdel|ls|inspect|show|status|del|delete|remove|uninstall)\b)"
    r"([^\n]*)"
)
FILES = regex(r"(?<![\w.+-])[\w+-]+\.\w+")
ENTERS = regex(r"\b(?:cd|pushd)[ \t]+([^\n;&|]+)")
TEMPORARY = regex(r"\bmktemp\b|\b(?:cd|pushd)[ \t]+[\"']?(?:/tmp|/var/tmp|\$\{?\w*(?:TMP|TEMP))", re.I)
DATED = regex(r"\bdate\b[ \t]+[\"']?[-+]")
UNPACKED = regex(r"\b(?:mktemp|tar|unzip|dpkg-deb)\b")
"""What makes the files of a folder anew."""
ADDRESS = regex(r"(?:https?|ssh|git)://|git@")
RELATIVE = regex(r"(?:\./)?[\w+-]+(?:/[\w+-]+)*\.\w+")
ADDS: dict[str, tuple[str, ...]] = {"docker": ("network", "create"), "ip": ("link", "add"), "dkms": ("add",)}
VALUED = ("-b", "--branch", "--depth", "-c", "-o", "--origin", "-j", "--jobs", "--reference", "--filter")
"""Options of git clone with a value of their own."""
NAME = regex(r"[\w.@+-]+")
WORD = regex(r"[A-Za-z_][\w.@+-]+")
HELD = regex(r"[\"']?\$")
"""A path that begins with a variable."""
FOLDER = regex(r"[ \t\"']((?:~|\$HOME|\$\{HOME\})?[\w./@+-]+)")
TESTS = ("[", "[[", "test")
IS_THERE = regex(r"-[edfhLrsx]")
FOUND_BY = ("which", "type", "dpkg", "pgrep", "id", "getent", "grep")
"""Programs that are asked whether something was done before."""
ENDS = ("exit", "return", "exec")
TALKS = ("echo", "printf", "exit")
USERS = ("groupadd", "useradd")
ONCE = ("ln", "mkdir", "rosdep")
"""What sets up a machine on which nothing is yet."""
AGAIN = regex(r"(?i)(?:^|[_.-])(?:update|upgrade|start|run|launch|deploy|sync|entrypoint|boot)(?:[_.-]|$)")
"""Names of scripts that people or the robot run more than once."""
FILE = regex(r"\.\w+\Z|/s?bin/[^/]+\Z")
"""What is no folder; a link to a folder gets the next link inside."""
ADVICE = {
    "rosdep": "write [ -e /etc/ros/rosdep/sources.list.d/20-default.list ] || before it",
    "groupadd": "write groupadd -f",
    "useradd": "write id NAME || before it",
    "mkdir": "write mkdir -p",
    "ln": "write ln -sfn",
    "git": "write [ -d FOLDER ] || before it",
    "docker": "write docker network inspect NAME || before it",
    "ip": "write ip link show NAME || before it",
    "dkms": "write dkms status | grep -q NAME || before it",
    "mv": "write cp",
}
EFFECTS = {"mv": "This moves a file of the checkout away"}


@rule(
    "warning",
    symptoms=[
        "ERROR: default sources list file already exists",
        "fatal: destination path '*' already exists and is not an empty directory.",
        "Error! DKMS tree already contains: ",
    ],
)
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
            if found is not None and not _is_asked_for(asked, found[2]) and not _is_new(robot, source, asked, *found):
                if robot.scripts.sets_up_image(source):
                    break
                program, made, _ = found
                effect = EFFECTS.get(program, "This fails when it is there already")
                yield finding(
                    made,
                    f"{effect}: under set -e the second run of {source.basename} ends here",
                    advice=ADVICE[program],
                    severity="info"
                    if program in USERS
                    or (program in ONCE and not _runs_again(robot, source))
                    or (
                        statement.among is always[0]
                        and _is_last(statement.among[statement.at + 1 :], program, made)
                        and not robot.scripts.starts_by_itself(source)
                    )
                    else None,
                )


def _runs_again(robot: Robot, source: Source) -> bool:
    return AGAIN.search(source.basename) is not None or robot.scripts.starts_by_itself(source)


def _is_last(later: tuple[Block, ...], program: str, made: Located) -> bool:
    """Whether nothing that the second run lacks comes after: only words, or what is done to the interface that is
    there already."""
    return program != "mv" and all(
        block.command is not None and (block.command.name in TALKS or (program == "ip" and made in block.command.words))
        for block in later
    )


def _is_new(robot: Robot, source: Source, asked: set[str], program: str, made: Located, _: str) -> bool:
    """Whether each run may begin in a new folder, or find the file that it moves."""
    if program == "git" or HELD.match(made):
        entered = source.once(ENTERS, lambda: frozenset(WORD.findall("\n".join(ENTERS.findall(source.text)))))
        held = WORD.findall(made.partition("/")[0]) if HELD.match(made) else ()
        is_dated = "$" in made and source.matches(DATED)
        return is_dated or source.matches(TEMPORARY) or not asked.isdisjoint((*entered, *held))
    if program == "mv" and not source.matches(UNPACKED):
        name = posixpath.basename(made)
        is_there = any(path.endswith(f"/{made.removeprefix('./')}") for path in robot.tree.named(name))
        return not is_there or source.once(FILES, lambda: Counter(FILES.findall(source.text)))[name] > 1
    return program == "mv"


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
    return command.name in FOUND_BY or "-v" in command.words[1:2] or _is_there(command)


def _is_there(command: Command) -> bool:
    return command.name in TESTS and any(map(IS_THERE.fullmatch, command.words))


def _named(blocks: tuple[Block, ...]) -> Iterator[str]:
    for block in blocks:
        if block.command is not None:
            yield block.command.name
        for body in block.bodies:
            yield from _named(body)


def _made(command: Command) -> tuple[str, Located, str] | None:
    """The program of a command that fails where something is there already, the word that says it, and what it is."""
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    plain = [word for word in words[1:] if not word.startswith("-")]
    letters = "".join(word for word in words[1:] if word.startswith("-"))
    if name == "rosdep":
        return (name, words[0], "20-default") if plain[:1] == ["init"] else None
    if name in ("groupadd", "useradd"):
        is_plain = "f" not in letters and plain and words[-1].isidentifier()
        return (name, words[-1], words[-1]) if is_plain else None
    if name == "mkdir":
        is_known = "p" not in letters and len(plain) == 1 and (KNOWN.fullmatch(plain[0]) or HELD.match(plain[0]))
        return (name, plain[-1], plain[-1]) if is_known else None
    if name == "ln":
        is_file = "s" in letters and "f" not in letters and len(plain) == 2 and FILE.search(plain[0])
        return (name, plain[1], _link(*plain)) if is_file and KNOWN.fullmatch(plain[1]) else None
    if name == "git" and plain[:1] == ["clone"]:
        found = _cloned(words[words.index("clone") + 1 :])
        return (name, found, _last(found)) if found is not None else None
    return _named_in(name, plain)


def _link(to: str, place: str) -> str:
    return f"{place}{posixpath.basename(to)}" if place.endswith("/") else place


def _named_in(name: str, plain: list[Located]) -> tuple[str, Located, str] | None:
    """The interface, network or module that a command adds, or the file that it moves away."""
    if name == "mv":
        return (name, plain[0], plain[0]) if len(plain) == 2 and RELATIVE.fullmatch(plain[0]) else None
    verbs = ADDS.get(name)
    if verbs is None or tuple(plain[: len(verbs)]) != verbs:
        return None
    rest = plain[len(verbs) :]
    made = _link_name(rest) if name == "ip" else (rest[-1] if name == "docker" and rest else next(iter(rest), None))
    return (name, made, made) if made is not None and WORD.fullmatch(made) else None


def _link_name(words: list[Located]) -> Located | None:
    """The name that ``ip link add`` gives: ``[link DEVICE] [name] NAME``."""
    rest = words[2:] if words[:1] == ["link"] else words
    return next((word for word in rest if word not in ("dev", "name")), None)


def _cloned(words: tuple[Located, ...]) -> Located | None:
    """The word that gives the folder of a clone its name: its own, or the address."""
    plain = [
        word
        for before, word in zip(("", *words), words, strict=False)
        if before not in VALUED and not word.startswith("-")
    ]
    return plain[-1] if plain and len(plain) < 3 and ADDRESS.match(plain[0]) else None


def _asked_for(text: str) -> set[str]:
    """The names and folders that a script looks for, or removes, the names with and without their suffixes."""
    rests = [found[1] for found in ASKS.finditer(text)]
    words = {word for rest in rests for word in NAME.findall(rest)}
    folders = {path.removesuffix("/") for rest in rests for path in FOLDER.findall(rest)}
    return words | folders | {word.partition(".")[0] for word in words} | {word.rpartition(".")[0] for word in words}


def _last(path: str) -> str:
    """The last part of a path or address, without the suffix of a repository."""
    return posixpath.basename(path.rstrip("/")).removesuffix(".git")


def _is_asked_for(asked: set[str], made: str) -> bool:
    """Whether the script looks for what it makes, or removes it, or a folder above it."""
    if not asked.isdisjoint(NAME.findall(_last(made))):
        return True
    parts = made.split("/", MOST)
    return any("/".join(parts[:end]) in asked for end in range(3 if made.startswith("/") else 2, len(parts)))
