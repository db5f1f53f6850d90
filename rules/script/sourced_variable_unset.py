"""A script reads a variable that the file which it sources sets under another name.

## What it finds
`$NAME` in a script, where neither the script nor any other file of the tree sets NAME, and a file of the tree that the
script sources sets a variable that the script does not read and whose name differs in a letter, or in one of three
words or more (`IP_OF_LIDAR` for `IP_OF_SCANNER`). All that the script sources has to be in its folder.

Silent where the script gives a default, tests whether NAME is set, reads it, or is itself sourced, and in files with
`eval`.

## Why it matters on a robot
The shell puts nothing in the place of the variable: a route is not added, a parameter is empty, a path begins at `/`.

## Bad
```sh
# addresses.sh sets IP_OF_LIDAR=192.168.1.201
. ./addresses.sh
ip route add "$IP_OF_SCANNER/32" dev eth1
```

## Good
```sh
. ./addresses.sh
ip route add "$IP_OF_LIDAR/32" dev eth1
```

## When to ignore it
When whoever calls the script sets the variable.

## References
- bash(1), "Parameter Expansion"
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
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.spelling import nearest
from bringup_lint.api.spelling import numbered

SOURCES = ("source", ".")
ASSIGNED = regex(r"[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+(?=\+?=)")
USED = regex(r"\$(?:\{(?P<braced>[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+)\}|(?P<plain>[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+)(?!\w))")
NAME = regex(r"\w+")
DECLARES = ("export", "declare", "readonly", "typeset", "local")
LEARNS = regex(r"\b(?:eval|mapfile|readarray|getopts|envsubst)\b|\bexport[ \t]+[\"']?[$`]|\bset[ \t]+-a\b")


@rule("warning", confidence="medium", symptoms=["*: unbound variable"])
def sourced_variable_unset(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or LEARNS.search(source.text):
            continue
        files = _sourced(robot, source)
        if files:
            yield from _unset(robot, source, files)


def _sourced(robot: Robot, source: Source) -> list[Source]:
    """The files of the folder that a script sources; none where one of them is not known."""
    found = []
    for command in shell_commands(source):
        if command.name in SOURCES and len(command.words) > 1:
            file = robot.tree.beside(source, command.words[1].rpartition("/")[2])
            if file is None or file is source or file.kind != "shell-script" or file.template:
                return []
            if LEARNS.search(file.text) or any(each.name in SOURCES for each in shell_commands(file)):
                return []
            found.append(file)
    return found


def _unset(robot: Robot, source: Source, files: list[Source]) -> Iterator[Finding]:
    given = {name: place for file in files for name, place in _assigned(file)}
    own = {name for name, _ in _assigned(source)}
    words = set(NAME.findall(source.text))
    unread = [each for each in given if each not in words]
    seen = set()
    for word, name in _used(source):
        if name in given or name in own or name in seen:
            continue
        seen.add(name)
        others = [each for each in unread if not numbered(name, each)]
        meant = [each for each in others if _differs_in_a_word(name, each)] or nearest(name, others)
        if len(meant) == 1 and not _may_be_set(robot, source, name):
            yield finding(
                word,
                f"Nothing sets {name}: it is empty here",
                advice=f"did you mean {meant[0]}?",
                related=[note(given[meant[0]], "set in the file that is sourced")],
            )


def _assigned(source: Source) -> Iterator[tuple[str, Located]]:
    for command in shell_commands(source):
        words = (*command.assignments, *(command.words[1:] if command.name in DECLARES else ()))
        yield from ((found[0], word) for word in words if (found := ASSIGNED.match(word)))


def _used(source: Source) -> Iterator[tuple[Located, str]]:
    """The variables that commands read, without a default, in words that are not in single quotes."""
    for command in shell_commands(source):
        for word in (*command.assignments, *command.words):
            if "'" not in word.span.text:
                for used in USED.finditer(word):
                    yield word.part(*used.span()), used["braced"] or used["plain"]


def _differs_in_a_word(name: str, other: str) -> bool:
    words, others = name.split("_"), other.split("_")
    changed = [pair for pair in zip(words, others) if pair[0] != pair[1]]
    return len(words) == len(others) > 2 and len(changed) == 1


def _may_be_set(robot: Robot, source: Source, name: str) -> bool:
    """Whether the name is anywhere but where its value is used, or in another file."""
    others = (each for each in robot.sources if each is not source)
    written = re.escape(name)
    set_here = rf"(?<![$\w{{]){written}\b|\$\{{[!#]?{written}[^\w}}]|(?:\[|\btest\b)[^\n]{{0,100}}\$\{{?{written}\b"
    sourced = re.compile(rf"(?:^|[;&])[ \t]*(?:source|\.)[ \t][^\n]*{re.escape(source.basename)}", re.M)
    return re.search(set_here, source.text) is not None or any(
        name in each.text or sourced.search(each.text) for each in others
    )
