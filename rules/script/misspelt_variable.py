"""A script reads a variable that has another name where it is set.

## What it finds
`$NAME` or `${NAME}` that is in no other place of the tree than where it is read, and that differs in one letter from
a variable that the script sets, or from a well-known one such as `BASH_SOURCE` or `ROS_DISTRO`: a letter is left out,
there twice, or the one beside it on the keyboard, or two are exchanged.

A variable of which nothing but its assignment is in the tree, one letter away from a variable that the script reads.

`$NAME` that nothing sets, where one word more or less gives a variable that the script sets, and that it reads within
four lines of it: `[ -f "$ROVER_SWAP_FILE" ]` before `sed -i ... "$SWAP_FILE"`.

Before a `/` in `rm -r` the names may differ in more. Then it is silent where the script sources files, reads variables
with `read`, `eval` or `export $(...)`, or runs under `set -u`.

Silent where the script gives a default or tests whether NAME is set.

## Why it matters on a robot
The shell puts nothing in the place of a variable that is not set: a path begins at `/`, a parameter is empty.
`rm -rf $LOGDIR/*` becomes `rm -rf /*`, and as root that deletes the robot. Under `set -u` the script ends there.

## Bad
```sh
LOG_DIR=/var/log/rover
rm -rf $LOGDIR/*
```

## Good
```sh
set -u
LOG_DIR=/var/log/rover
rm -rf "${LOG_DIR:?}"/*
```

## When to ignore it
When whoever calls the script sets the variable.

## References
- bash(1), "Parameter Expansion"
- https://www.shellcheck.net/wiki/SC2115
- https://www.shellcheck.net/wiki/SC2153
"""

import re
from collections import Counter
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import variables
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import Word
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.shell import with_inner
from bringup_lint.api.spelling import Neighbours
from bringup_lint.api.spelling import is_slip
from bringup_lint.api.spelling import nearest
from bringup_lint.api.spelling import numbered

USED = regex(r"[\"']?\$(?:\{(?P<braced>[A-Za-z_]\w*)\}|(?P<plain>[A-Za-z_]\w*))[\"']?/")
RECURSIVE = regex(r"-[a-zA-Z]*[rR][a-zA-Z]*|--recursive")
LEARNS = regex(
    r"(?m)(?:^|[;&|({]|\b(?:then|do|else))[ \t]*(?:source|\.|eval)[ \t]|^#![^\n]{0,80}[ \t]-[a-z]{0,8}u|\bnounset\b"
    r"|^[ \t]*set[ \t][^\n]{0,60}-[a-z]{0,8}u|\b(?:export|declare|readonly)[ \t]+[\"']?[$`]"
)
GIVEN = frozenset("HOME PWD OLDPWD USER TMPDIR DESTDIR WORKSPACE TARGET_DIR ROOTFS_DIR ROS_HOME ROS_LOG_DIR".split())
"""Variables that a login, a build or ROS gives."""
ASSIGNED = regex(r"[A-Za-z_]\w*(?==)")
SET = regex(r"[A-Za-z_]\w*(?=\+?=|\Z)")
DECLARES = ("export", "declare", "readonly", "typeset", "local", "read")
LOOP = regex(r"\bfor[ \t]+([A-Za-z_]\w*)")
READ = regex(r"\$(?:(?P<plain>[A-Za-z_]\w{4,})|\{(?P<braced>[A-Za-z_]\w{4,})(?:\[[@*\d]\]|[%#/^,][^}\n]{0,200})?\})")
WELL_KNOWN = (
    "AMENT_PREFIX_PATH BASH_SOURCE CMAKE_PREFIX_PATH COLCON_PREFIX_PATH DEBIAN_FRONTEND DISPLAY FUNCNAME HOSTNAME "
    "LD_LIBRARY_PATH LOGNAME OLDPWD PIPESTATUS PYTHONPATH ROS_DISTRO SUDO_USER XAUTHORITY XDG_RUNTIME_DIR"
).split()
"""Variables that the shell, the login or the setup files of ROS give."""
SIZE = 200_000
LEAST = 6
"""Letters of a name that is set and never read."""
LINES = 4
ON_A_LINE = 50
"""Names on one line that are looked at."""
OF_A_SESSION = regex(r"(?:XDG|SSH|SUDO|CI|GITHUB|GITLAB|RUNNER|BUILDKITE|JENKINS)_")
"""Variables that a login or a build server gives."""
WORD = regex(r"\w+")
NAMED = regex(r"(?<![$\w{])[A-Za-z_]\w*")
OF_ANY = regex(r"\$\{(?:!?([A-Za-z_]\w*)(?=:?[-=+?])|[!#]([A-Za-z_]\w*)(?=\W))")
OF_FOLDERS = regex(r"\$\{(?:!?([A-Za-z_]\w*)(?=[^\w}])|[!#]([A-Za-z_]\w*)(?=\W))")
USE = regex(r"\$\{?([A-Za-z_]\w*)")
TESTED = regex(r"(?:\[|\btest)[ \t]-[nzv][ \t]{1,100}[\"']?\Z")
TESTED_AT_ALL = regex(r"(?:\[|\btest)[ \t][^\n]{0,100}[\"']?\Z")
TEST_ENDS = regex(r"[^\n]{0,100}(?:\]|&&|\|\|)")
FEW = 40
"""Names that are looked for in each file; for more of them, all words of the files are read."""
EXPORTS_ALL = regex(r"\bset[ \t]+-\w{0,6}a|\ballexport\b")


class Elsewhere:
    """The words of the other files."""

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._asked: dict[tuple[Source, str], bool] = {}

    def has(self, source: Source, name: str) -> bool:
        key = source, name
        if key not in self._asked:
            is_few = len(self._asked) < FEW
            self._asked[key] = self._is_in(source, name) if is_few else self._files[name] > self._own(source, name)
        return self._asked[key]

    def _is_in(self, source: Source, name: str) -> bool:
        alone = re.compile(rf"(?<!\w){re.escape(name)}(?!\w)")
        return any(name in each.text and alone.search(each.text) for each in self._robot.sources if each is not source)

    def _own(self, source: Source, name: str) -> bool:
        return name in source.once((WORD, "words"), lambda: frozenset(WORD.findall(source.text)))

    @cached_property
    def _files(self) -> Counter[str]:
        """Word -> how many files have it."""
        return Counter(word for each in self._robot.sources for word in set(WORD.findall(each.text)))


@rule(
    "error",
    confidence="medium",
    symptoms=["rm: it is dangerous to operate recursively on '/'", "*: unbound variable"],
)
def misspelt_variable(robot: Robot) -> Iterator[Finding]:
    elsewhere = Elsewhere(robot)
    said = set()
    for found in _deleted(robot, elsewhere):
        said.add(found.span)
        yield found
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and len(source.text) <= SIZE and "$" in source.text:
            yield from (found for found in _read(elsewhere, source) if found.span not in said)


def _read(elsewhere: Elsewhere, source: Source) -> Iterator[Finding]:
    """The variables that differ in a letter from one that is set."""
    commands = list(with_inner(shell_commands(source)))
    given = {name: place for command in commands for name, place in _given(command)}
    loops = LOOP.findall(source.text)
    slips: Neighbours | None = None
    seen = {*given, *loops}
    reads = [read for command in commands for read in _reads(command)]
    yield from _unread(elsewhere, source, commands, dict((name, word) for word, name in reversed(reads)))
    yield from _longer(elsewhere, source, commands, reads)
    for word, name in reads:
        if name not in seen:
            seen.add(name)
            slips = slips or Neighbours((*given, *loops, *WELL_KNOWN, *variables()))
            meant = [each for each in slips.meant(name) if _is_slip(name, each)]
            if meant and not _may_be_set(elsewhere, source, name, general=True):
                yield finding(
                    word,
                    f"Nothing sets {name}: it is empty here",
                    advice=f"did you mean {meant[0]}?",
                    related=[note(given[each], "this is set") for each in meant if each in given],
                    severity="warning",
                )


def _unread(
    elsewhere: Elsewhere, source: Source, commands: list[Command], reads: dict[str, Located]
) -> Iterator[Finding]:
    """The variables that are set and never read, beside one of nearly the name that is read."""
    if EXPORTS_ALL.search(source.text):
        return
    given = {name for command in commands for name, _ in _given(command)}
    slips: Neighbours | None = None
    for command in commands:
        if command.words and command.name not in ("local", "readonly", "declare"):
            continue
        for name, place in _given(command):
            if len(name) < LEAST or source.text.count(name) > 1 or name in reads:
                continue
            slips = slips or Neighbours(reads)
            meant = [each for each in slips.meant(name) if _is_slip(name, each) and not name.startswith(each)]
            if len(meant) != 1 or meant[0].startswith(name) or elsewhere.has(source, name):
                continue
            if meant[0] in given or _may_be_set(elsewhere, source, meant[0], general=True):
                yield finding(
                    place,
                    f"Nothing reads {name}: {meant[0]} does not get this value",
                    advice=f"write {meant[0]}",
                    related=[note(reads[meant[0]], "this is read")],
                    severity="warning",
                )


def _longer(
    elsewhere: Elsewhere, source: Source, commands: list[Command], reads: list[tuple[Located, str]]
) -> Iterator[Finding]:
    """The variables that nothing sets, near one that has a word more or less, and that is set before."""
    places = [each for command in commands for each in _given(command)]
    given = dict(reversed(places))
    given_at = {(name, place.line) for name, place in places}
    by_line: dict[int, set[str]] = {}
    for word, name in reads:
        names = by_line.setdefault(word.line, set())
        if len(names) < ON_A_LINE:
            names.add(name)
    seen = set()
    for word, name in reads:
        if name in given or name in seen or name.count("_") < 1 or OF_A_SESSION.match(name):
            continue
        seen.add(name)
        lines = range(word.line - LINES, word.line + LINES + 1)
        near = {each for line in lines for each in by_line.get(line, ())}
        meant = [each for each in near if each in given and _has_one_word_more(name, each)]
        is_made_of_it = any((each, word.line + at) in given_at for each in meant for at in range(LINES + 1))
        if len(meant) == 1 and not is_made_of_it and not _may_be_set(elsewhere, source, name, general=True):
            yield finding(
                word,
                f"Nothing sets {name}: it is empty here",
                advice=f"did you mean {meant[0]}?",
                related=[note(given[meant[0]], "this is set")],
                severity="warning",
            )


def _has_one_word_more(one: str, other: str) -> bool:
    """Whether one of two names has all words of the other in their order, and one more."""
    short, long = sorted((one.split("_"), other.split("_")), key=len)
    return len(long) == len(short) + 1 > 2 and any(long[:at] + long[at + 1 :] == short for at in range(len(long)))


def _given(command: Command) -> Iterator[tuple[str, Located]]:
    for word in (*command.assignments, *(command.words[1:] if command.name in DECLARES else ())):
        if found := SET.match(word):
            yield found[0], word


def _reads(command: Command) -> Iterator[tuple[Located, str]]:
    """The variables that the words of a command read without a default, outside single quotes and ``$(...)``."""
    targets = (each.target for each in command.redirects if each.target is not None)
    for word in (*command.assignments, *command.words, *targets):
        if "$" in word and "$(" not in word and "`" not in word and isinstance(word, Word):
            for stretch, quote in word.stretches():
                if quote != "'":
                    for read in READ.finditer(stretch):
                        yield stretch.part(*read.span()), read["plain"] or read["braced"]


def _is_slip(name: str, meant: str) -> bool:
    """Whether one is the other misspelt, and not several of them, another of several, or its name in another style."""
    same = name.replace("_", "") == meant.replace("_", "") or name.rstrip("sS") == meant.rstrip("sS")
    return is_slip(name, meant) and not same and not numbered(name, meant)


def _deleted(robot: Robot, elsewhere: Elsewhere) -> Iterator[Finding]:
    """The folders that ``rm -r`` deletes instead."""
    of_scripts: dict[Source, dict[str, Located]] = {}
    for source, run in robot.scripts.run("rm"):
        if not any(map(RECURSIVE.fullmatch, run.words)) or source.matches(LEARNS):
            continue
        for word in run.words[1:]:
            used = USED.match(word.span.text)
            name = (used["braced"] or used["plain"]) if used else ""
            if not name or name in GIVEN or word.span.text.startswith("'") or _may_be_set(elsewhere, source, name):
                continue
            if source not in of_scripts:
                of_scripts[source] = _assigned(robot, source)
            assigned = of_scripts[source]
            meant = nearest(name, assigned)
            if meant:
                yield finding(
                    word,
                    f"Nothing sets {name}: this deletes '{word[word.index('/') :]}'",
                    advice=f"write ${{{meant[0]}:?}}, which stops the script where it is empty",
                    related=[note(assigned[meant[0]], "this is set")],
                )


def _may_be_set(elsewhere: Elsewhere, source: Source, name: str, *, general: bool = False) -> bool:
    """Whether the name is anywhere but where its value is used, in a test before it, or in another file."""
    known = source.once((_set_in, general), lambda: _set_in(source.text, general))
    return name in known or elsewhere.has(source, name)


def _set_in(text: str, general: bool) -> set[str]:
    """The names that may get a value in a text, or are tested in it."""
    found = set(NAMED.findall(text))
    found.update(name for names in (OF_ANY if general else OF_FOLDERS).findall(text) for name in names)
    before = TESTED if general else TESTED_AT_ALL
    for used in USE.finditer(text):
        if used[1] not in found and TEST_ENDS.match(text, used.end()):
            if before.search(text, max(0, used.start() - 120), used.start()):
                found.add(used[1])
    return found


def _assigned(robot: Robot, source: Source) -> dict[str, Located]:
    """The variables that a script sets."""
    runs = (did for did in robot.scripts.done(source) if isinstance(did, Run))
    words = (word for run in runs for word in (*run.command.assignments, *run.words[1:]))
    return {found[0]: word for word in words if (found := ASSIGNED.match(word))}
