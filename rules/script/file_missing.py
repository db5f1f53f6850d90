"""A script copies, sources or runs a file that is not there.

## What it finds
A file of the script's own folders that `cp`, `install`, `source`, `bash`, `python3` or its path names and that does not
exist: below a variable that holds the folder of the script, where another file exists that the script names so, and for
relative paths, below the one folder in which at least two other files exist that the script names.

Not reported: files that the script names a second time (it may make or test them), files of builds, ignored files and
those of submodules, patterns, and commands whose failure is expected (`||`, `2>/dev/null`).

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

COPIES = ("cp", "install")
READS = ("source", ".", "bash", "sh", "python3", "python")
VALUED = ("-o", "-g", "-m", "-S", "-t")
GENERATED = regex(
    r"(?:^|/)(?:install|devel|build|log|\.?v?env|node_modules|target|dist|out|output|tmp|certs?|keys?|keystore)/|\.env$"
)
SELF = regex(
    r"^[ \t]*(?:readonly[ \t]+|export[ \t]+|local[ \t]+|declare[ \t]+-\w+[ \t]+)?(?P<name>\w+)="
    r"[\"']?\$\([^\n]{0,60}?dirname[^\n]{0,40}(?:\$0|BASH_SOURCE|\$\{0\})[^\n/]{0,40}$",
    re.M,
)
"""A variable that holds the folder of the script."""
MOVES = regex(r"^[ \t]*(?:cd|pushd)[ \t]+(?P<to>[^\n;&|]+)", re.M)
PLAIN = regex(r"(?:\./)?[A-Za-z0-9_.+-]+(?:/[A-Za-z0-9_.+-]+)*\.[A-Za-z0-9]+")
LEAST = 2
"""Other files of the same folder that show that relative paths start there."""


class Named(NamedTuple):
    word: Located
    path: str
    """Relative to the base."""
    own: bool
    """Below the folder of the script, as the script says."""


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
    folders = {match["name"] for match in SELF.finditer(source.text)}
    runs = [did for did in robot.scripts.done(source) if isinstance(did, Run)]
    named = list(dict.fromkeys(each for run in runs for each in _named(run, folders)))
    base = _base(robot, source, [each for each in named if not each.own])
    here = posixpath.dirname(source.name)
    if not any(each.own and robot.tree.exists(posixpath.join(here, each.path)) for each in named):
        named = [each for each in named if not each.own]
    for each in named:
        folder = here if each.own else base
        if folder is not None and _is_missing(robot, source, posixpath.join(folder, each.path)):
            yield each


def _named(run: Run, folders: set[str]) -> Iterator[Named]:
    """The files that a command surely reads."""
    if run.command.ends in ("||", "&&") or any(each.descriptor == "2" for each in run.command.redirects):
        return
    for word in _read(run):
        text = run.text(word)
        below = re.fullmatch(r"\{\{ (\w+) \}\}/(.+)", text)
        if below and below[1] in folders and PLAIN.fullmatch(below[2]):
            yield Named(word, posixpath.normpath(below[2]), True)
        elif PLAIN.fullmatch(text) and str(word) == text:
            yield Named(word, posixpath.normpath(text), False)


def _read(run: Run) -> Iterator[Located]:
    words = run.words
    if run.name in COPIES:
        given = [
            word for at, word in enumerate(words) if at and not word.startswith("-") and words[at - 1] not in VALUED
        ]
        if not any(re.fullmatch(r"-[a-zA-Z]*[dt][a-zA-Z]*|--directory", word) for word in words[1:]):
            yield from given[:-1]
    elif run.name in READS and len(words) > 1 and not words[1].startswith("-"):
        yield words[1]
    elif words and words[0].startswith("./"):
        yield words[0]


def _base(robot: Robot, source: Source, named: list[Named]) -> str | None:
    """The folder in which relative paths start; None when that is not clear."""
    here = posixpath.dirname(source.name)
    moves = [match["to"] for match in MOVES.finditer(source.text)]
    if any("dirname" not in to for to in moves):
        return None
    folders = [here]
    while not moves and folders[-1] not in ("", "/"):
        folders.append(posixpath.dirname(folders[-1]))
    counts = {each: sum(robot.tree.is_file(posixpath.join(each, one.path)) for one in named) for each in folders}
    best = max(folders, key=lambda each: counts[each])
    return best if counts[best] >= LEAST and list(counts.values()).count(counts[best]) == 1 else None


def _is_missing(robot: Robot, source: Source, path: str) -> bool:
    name = posixpath.basename(path)
    if robot.tree.exists(path) or GENERATED.search(path) or robot.tree.is_ignored(path):
        return False
    if len(re.findall(rf"(?<![\w.-]){re.escape(name)}(?![\w-])", _without_comments(source.text))) > 1:
        return False
    folder = posixpath.dirname(path)
    if any(os.path.abspath(path).startswith(each) for each in robot.tree.submodules):
        return False
    return robot.tree.exists(folder or ".")


def _without_comments(text: str) -> str:
    return re.sub(r"^[ \t]*#[^\n]*", "", text, flags=re.M)
