"""A script copies, sources or runs a file that is not there.

## What it finds
A file of the script's own folders that `cp`, `install`, `ln`, `source`, `bash`, `python3`, `pip install -r`,
`docker ... -f` or its path names and that does not exist: below a variable that holds the folder of the script or one
near it (`$(cd "$(dirname "$0")/.." && pwd)`), where another file exists that the script names so, and for relative
paths, below the one folder in which another file exists that the script names (two for names without a folder).
A pattern such as `udev/*.rules` that matches no file is reported in the same way.

Not reported: files that the script names a second time (it may make or test them), files of builds, ignored files and
those of submodules, and commands whose failure is expected (`||`, `2>/dev/null`).

## Why it matters on a robot
With `set -e` the installation stops in the middle: the first files are copied, and no service is enabled. Without it
the error scrolls past, and the robot boots without what the file was for.

## Bad
```sh
cp rover.service /etc/systemd/system/
cp rover.rules /etc/udev/rules.d/        # the file is called 99-rover.rules
```

## Good
```sh
cp rover.service /etc/systemd/system/
cp 99-rover.rules /etc/udev/rules.d/
```

## When to ignore it
When people put the file there before they run the script.

## References
- cp(1), bash(1)
"""

import os
import posixpath
import re
from collections.abc import Iterator
from typing import NamedTuple

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

COPIES = ("cp", "install", "ln")
READS = ("source", ".", "bash", "sh", "python3", "python")
TAKES = {"pip": ("-r", "--requirement"), "pip3": ("-r", "--requirement"), "docker": ("-f", "--file")}
TAKES["docker-compose"] = TAKES["docker"]
"""Options with a file that the command reads."""
VALUED = ("-o", "-g", "-m", "-S", "-t")
GENERATED = regex(
    r"(?:^|/)(?:install|devel|build|log|\.?v?env|node_modules|target|dist|out|output|tmp|certs?|keys?|keystore)/|\.env$"
)
ASSIGNED = regex(
    r"^[ \t]*(?:readonly[ \t]+|export[ \t]+|local[ \t]+|declare[ \t]+-\w+[ \t]+)?(?P<name>\w+)="
    r"(?P<value>[\"']?\$[({\w][^\n]{0,200})$",
    re.M,
)
SELF = regex(r"\$\([^\n]{0,60}?dirname[^\n]{0,40}(?:\$0|BASH_SOURCE|\$\{0\})")
OTHER = regex(r"[\"']?(?:\$\((?:cd|dirname|realpath|readlink -f)[ \t]+(?:-\S+[ \t]+)*)?[\"']?\$\{?(?P<name>\w+)\}?")
QUIET = regex(r"[12&]?>[ \t]*/dev/null|2>&1|&&.*$")
MOVES = regex(r"^[ \t]*(?:cd|pushd)[ \t]+(?P<to>[^\n;&|]+)", re.M)
PLAIN = regex(r"(?:\./)?[A-Za-z0-9_.+-]+(?:/[A-Za-z0-9_.+-]+)*(?:\.[A-Za-z0-9]+|/[\w.-]*\*\.[a-z]+)")
BELOW = regex(r"\{\{ (\w+) \}\}/(.+)")
LEAST = 2
"""Other files of the same folder that show that relative paths start there."""


class Named(NamedTuple):
    word: Located
    path: str
    """Relative to the folder."""
    folder: str | None
    """The folder that the script says, relative to its own; None: it is not said."""


class Base(NamedTuple):
    folder: str | None = None
    """The folder in which relative paths start; None when that is not clear."""
    shown: int = 0
    """How many files show it."""


@rule("warning", symptoms=["cannot stat"])
def file_missing(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and source.origin is None:
            missing = list(_missing(robot, source))
            if missing:
                first, *others = missing
                yield finding(
                    first.word,
                    f"There is no {first.path}: this command fails",
                    advice="correct the name, or add the file",
                    related=[note(other.word, f"nor {other.path}") for other in others],
                )


def _missing(robot: Robot, source: Source) -> Iterator[Named]:
    folders = _own_folders(source.text)
    runs = [did for did in robot.scripts.done(source) if isinstance(did, Run)]
    named = list(
        dict.fromkeys(each for at, run in enumerate(runs) if _is_needed(runs[at:]) for each in _named(run, folders))
    )
    base = _base(robot, source, [each for each in named if each.folder is None])
    here = posixpath.dirname(source.name)
    there = {
        path
        for each in named
        if each.folder is not None
        and robot.tree.exists(path := posixpath.normpath(posixpath.join(here, each.folder, each.path)))
    }
    for each in named:
        folder = _start(each, base) if each.folder is None else posixpath.normpath(posixpath.join(here, each.folder))
        if each.folder is not None and not any(path.startswith(str(folder).lstrip(".")) for path in there):
            continue
        if folder is not None and _is_missing(robot, source, folder, each):
            yield each


def _start(named: Named, base: Base) -> str | None:
    """The folder in which a relative path starts; None when too little shows it."""
    return base.folder if base.shown >= LEAST or "/" in named.path else None


def _own_folders(text: str) -> dict[str, str]:
    """Variables that hold the folder of the script or one near it -> the path from there. Not those that a second
    line changes."""
    found: dict[str, str] = {}
    for match in ASSIGNED.finditer(text):
        name, value = match["name"], QUIET.sub("", match["value"])
        other = OTHER.match(value)
        if SELF.search(value):
            path = _steps(value, value.count("dirname") - 1)
        elif other is not None and other["name"] in found:
            path = _steps(value[other.end() :], value[: other.end()].count("dirname"))
            path = None if path is None else posixpath.normpath(posixpath.join(found[other["name"]], path))
        else:
            path = None
        if path is None or found.get(name, path) != path:
            found.pop(name, None)
        else:
            found[name] = path
    return found


def _steps(value: str, up: int) -> str | None:
    """The path that the rest of a value adds to a folder; None where it is not clear."""
    rest = re.sub(r"\$\{BASH_SOURCE[^}]*\}|\$\{?0\}?|\$BASH_SOURCE", "", value)
    if re.search(r"[|;*]|\$\{?\w|basename", rest.replace("$(", "(")):
        return None
    parts = re.findall(r"/([\w.-]+)", rest)
    return posixpath.normpath(posixpath.join(*[".."] * up, *parts, "."))


def _named(run: Run, folders: dict[str, str]) -> Iterator[Named]:
    """The files that a command reads."""
    for word in _read(run):
        text = run.text(word)
        below = BELOW.fullmatch(text)
        if below and below[1] in folders and PLAIN.fullmatch(below[2]):
            yield Named(word, posixpath.normpath(below[2]), folders[below[1]])
        elif PLAIN.fullmatch(text) and str(word) == text:
            yield Named(word, posixpath.normpath(text), None)


def _is_needed(runs: list[Run]) -> bool:
    """Whether nothing shows that the first command may fail."""
    if any(each.descriptor == "2" for each in runs[0].command.redirects):
        return False
    ends = next((run.command.ends for run in runs if run.command.ends != "&&"), "")
    return ends != "||"


def _read(run: Run) -> Iterator[Located]:
    words = run.words
    if run.name in COPIES:
        given = [
            word for at, word in enumerate(words) if at and not word.startswith("-") and words[at - 1] not in VALUED
        ]
        if run.name != "ln" and any(re.fullmatch(r"-[a-zA-Z]*[dt][a-zA-Z]*|--directory", word) for word in words[1:]):
            return
        yield from (word for word in given[:-1] if run.name != "ln" or word.startswith("$"))
    elif run.name in READS and len(words) > 1 and not words[1].startswith("-"):
        yield words[1]
    elif words and words[0].startswith(("./", "$")) and "/" in words[0]:
        yield words[0]
    else:
        options = TAKES.get(run.name, ())
        yield from (word for at, word in enumerate(words) if at and words[at - 1] in options)


def _base(robot: Robot, source: Source, named: list[Named]) -> Base:
    here = posixpath.dirname(source.name)
    moves = [match["to"] for match in MOVES.finditer(source.text)]
    if any("dirname" not in to for to in moves):
        return Base()
    folders = [here]
    while not moves and folders[-1] not in ("", "/"):
        folders.append(posixpath.dirname(folders[-1]))
    counts = {each: sum(robot.tree.is_file(posixpath.join(each, one.path)) for one in named) for each in folders}
    best = max(folders, key=lambda each: counts[each])
    certain = counts[best] and list(counts.values()).count(counts[best]) == 1
    return Base(best, counts[best]) if certain else Base()


def _is_missing(robot: Robot, source: Source, base: str, named: Named) -> bool:
    path = posixpath.normpath(posixpath.join(base, named.path))
    folder, _, name = path.rpartition("/")
    if robot.tree.exists(path) or GENERATED.search(path) or robot.tree.is_ignored(path.replace("*", "any")):
        return False
    if any(os.path.abspath(path).startswith(each) for each in robot.tree.submodules):
        return False
    if "*" in name:
        return not robot.tree.matches(path) and (
            robot.tree.exists(folder or ".") or _is_missing_folder(robot, source, folder)
        )
    if len(re.findall(rf"(?<![\w.-]){re.escape(name)}(?![\w-])", _without_comments(source.text))) > 1:
        return False
    return robot.tree.exists(folder or ".") or (named.folder is not None and _is_missing_folder(robot, source, folder))


def _is_missing_folder(robot: Robot, source: Source, folder: str) -> bool:
    """Whether the folder above is there, and nothing in the script makes this one."""
    above, _, name = folder.rpartition("/")
    made = re.search(
        rf"\b(?:mkdir|clone|unzip|tar|rsync|scp|wget|curl|colcon)\b[^\n]*(?<![\w.-]){re.escape(name)}\b", source.text
    )
    return robot.tree.exists(above or ".") and made is None


def _without_comments(text: str) -> str:
    return re.sub(r"^[ \t]*#[^\n]*", "", text, flags=re.M)
