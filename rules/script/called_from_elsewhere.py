"""A script finds its files from one folder only, and is called from another.

## What it finds
A file or folder that a script names relative to the folder in which it is started (`cp ./rover.rules`, `cd src`,
`source setup.sh`, `./build.sh`), and that is there from its own folder or one above, where a page, another script, a
Makefile or its own comment calls the script by a path from a folder in which it is not: `./scripts/install.sh`.

Silent where the script has to do with its own path (`$0`, `BASH_SOURCE`), names the file a second time (it may make or
test it), runs the command under a condition or expects its failure, and for paths after a `cd`.

## Why it matters on a robot
Called as the page says, the script does not find the file. Without `set -e` it goes on, and says at its end that all is
well: the udev rule or the unit is not installed.

## Bad
```sh
# README.md: sudo ./scripts/install.sh
cp ./99-rover.rules /etc/udev/rules.d/
```

## Good
```sh
cd "$(dirname "$0")" || exit 1
cp ./99-rover.rules /etc/udev/rules.d/
```

## When to ignore it
When the page goes into the folder before the call, and the path only shows where the script is.

## References
- bash(1), "Special Parameters": 0
- https://mywiki.wooledge.org/BashFAQ/028
"""

import posixpath
from collections import Counter
from collections.abc import Collection
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import read_words

CALLERS = regex(r"\.(?:md|rst|txt|sh|bash|desktop)$|(?:^|/)(?:README|GNUmakefile|[mM]akefile|[jJ]ustfile)$")
CALL = regex(
    r"(?:^|(?<=[\s`\"(;&|@]))(?:(?P<program>bash|sh|sudo|source|\.)[ \t]{1,4})?"
    r"(?P<path>(?P<dot>\./)?(?:[\w-][\w.-]{0,80}/){1,8}(?P<name>[\w-][\w.-]{0,80}))(?![\w./-])",
    hints="/",
)
COMMAND = regex(
    r"(?:^[ \t]*(?:[$#>+@-][ \t]*|\d{1,2}[.)][ \t]+)?|(?:&&|[|;]|(?<!\])\()[ \t]*|Exec="
    r"|(?i:\busage:?[ \t]+|\brun:[ \t]+)"
    r"|\b(?:then|do|else|exec|nohup|time)[ \t]+)(?:\w+=\S*[ \t]+)*(?:(?:sudo|env)[ \t]+(?:-\w+[ \t]+)*)?\Z"
    r"|(?i:\b(?:run|execut|call|start|launch|invok)(?:e|ing)?\b)[^.\n`]{0,40}`[^\n`]{0,80}\Z"
)
"""What is before a call in its line: it begins a command, or a sentence says that one runs it."""
OWN_PATH = regex(r"\bBASH_SOURCE\b|\bdirname\b|\$\{?0\b|\brealpath\b|\breadlink\b|%x|\bgit[ \t]+rev-parse\b")
RELATIVE = regex(r"(?:\.\.?/)*[A-Za-z0-9_+-][\w.+-]*(?:/[\w.+-]+)*/?")
TALK = regex(r"(?m)^[ \t]*(?:echo|printf)[ \t][^\n]*")
WORD = regex(r"[\w.+-]+")
MOST_DOTS = 8
"""Of a word, that are looked at."""
FEW = 20
"""Names that are looked for one by one."""
MOVES = ("cd", "pushd")
MOST = 200_000


class Needed(NamedTuple):
    """What a script needs from the folder in which it is started."""

    word: Located
    path: str


@rule(
    "warning",
    symptoms=["cp: cannot stat *: No such file or directory", "*.sh: line *: cd: *: No such file or directory"],
)
def called_from_elsewhere(robot: Robot) -> Iterator[Finding]:
    needed: dict[str, tuple[Source, list[Needed]]] = {}
    for source in robot.of_kind("shell-script"):
        if source.judged and "/" in source.name and not source.template and not source.matches(OWN_PATH):
            named = list(_needed(robot, source))
            if named:
                needed[source.absolute] = source, named
    asked: set[tuple[str, str]] = set()
    for script, call in _calls(robot, needed):
        source, named = needed[script]
        started = posixpath.normpath(source.name)[: -len(posixpath.normpath(call))]
        if (script, started) in asked:
            continue
        asked.add((script, started))
        missing = (each for each in named if not _is_there(robot, source, started, each.path))
        lost = [(each, folder) for each in missing if (folder := _home(robot, source, each)) is not None]
        if lost:
            (first, folder), *others = lost
            where = posixpath.dirname(posixpath.join(folder, first.path)) or "the folder above"
            yield finding(
                first.word,
                f"Called as {call}, the script does not find {first.path}, which is in {where}",
                advice='begin with cd "$(dirname "$0")", or name the file from there',
                related=[note(call, "the call"), *(note(each.word, "nor this one") for each, _ in others[:20])],
            )
            del needed[script]


def _needed(robot: Robot, source: Source) -> Iterator[Needed]:
    """The relative paths that a script surely takes before it goes elsewhere."""
    for run in robot.scripts.done(source):
        if not isinstance(run, Run):
            continue
        moves = run.name in MOVES
        if run.certain and run.command.ends != "||" and not run.command.hides_errors:
            for word in run.words[1:2] if moves else read_words(run):
                path = posixpath.normpath(str(word))
                if run.text(word) == word and RELATIVE.fullmatch(path) and _is_named_once(source, path):
                    yield Needed(word, path)
        if moves:
            return


def _is_named_once(source: Source, path: str) -> bool:
    """Whether no other line of a script has to do with the file."""
    return source.once(TALK, lambda: _lines_with_names(source))[posixpath.basename(path)] == 1


def _lines_with_names(source: Source) -> Counter[str]:
    """How many lines of a script have each word, with and without what follows a dot in it."""
    found: Counter[str] = Counter()
    for line in TALK.sub("", source.uncommented).splitlines():
        parts = [word.split(".", MOST_DOTS) for word in WORD.findall(line)]
        found.update({".".join(each[:end]) for each in parts for end in range(1, len(each) + 1)})
    return found


def _calls(robot: Robot, needed: Collection[str]) -> Iterator[tuple[str, Located]]:
    """The calls of scripts by a path from a folder above them, as long as they are among the ones to look for."""
    names = {posixpath.basename(script) for script in needed}
    if not names:
        return
    for path in robot.tree.like(CALLERS):
        text = robot.tree.head(path, MOST)
        is_named = not names.isdisjoint(WORD.findall(text)) if len(names) > FEW else any(map(text.__contains__, names))
        source = robot.tree.read(path, judged=False) if is_named else None
        if source is None:
            continue
        for match in CALL.finditer(source.text):
            if match["name"] in names and (
                match["program"] or (match["dot"] and _begins_command(source, match.start()))
            ):
                script = _meant(robot, match["path"])
                if script in needed:
                    yield script, source.located(*match.span("path"))


def _begins_command(source: Source, start: int) -> bool:
    """Whether what is said there is a call, and not a word about a file or what a program gets."""
    line = source.text.rfind("\n", 0, start) + 1
    before = source.text[max(line, start - 200) : start]
    return not before.lstrip().startswith("|") and COMMAND.search(before) is not None


def _meant(robot: Robot, call: str) -> str:
    """The only script of the tree that a call can mean; empty where there is none, or several."""
    end = "/" + posixpath.normpath(call)
    found = [path for path in robot.tree.named(posixpath.basename(call)) if path.endswith(end)]
    return found[0] if len(found) == 1 else ""


def _home(robot: Robot, source: Source, needed: Needed) -> str | None:
    """The folder of the script or one above it from which a path is there."""
    folder = posixpath.dirname(source.name)
    while not _is_there(robot, source, folder, needed.path):
        if not folder:
            return None
        folder = posixpath.dirname(folder)
    return folder


def _is_there(robot: Robot, source: Source, folder: str, path: str) -> bool:
    """Whether a path is there from a folder of the tree on, or leads out of it."""
    whole = posixpath.normpath(posixpath.join(folder, path))
    return whole.startswith("..") or robot.tree.exists(source.absolute[: -len(source.name)] + whole)
