"""A tilde in quotes is not the home.

## What it finds
A path that begins with a quoted `~/`, in a command that opens it (`cd`, `source`, `mkdir`, `cp`, ...), or in a variable
that such a command uses later.

Silent where the script itself puts the home in place of the tilde (`${NAME/#\\~/$HOME}`, `eval`). Silent, too, where
the variable may be set anew (a sourced file, a `for`, another function), and where a file called `~` is removed.

## Why it matters on a robot
The shell looks for a folder that is called `~`. The workspace is not sourced and its packages are unknown, or `mkdir`
makes a folder `~` where the script runs, and the recordings are not where anybody looks for them.

## Bad
```bash
WS="~/rover_ws"
source "$WS/install/setup.bash"
```

## Good
```bash
WS="$HOME/rover_ws"
source "$WS/install/setup.bash"
```

## When to ignore it
When a folder really has that name.

## References
- bash(1), "Tilde Expansion"
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
from bringup_lint.api.shell import Run

QUOTED = regex(r"[\"']~(?:/|[\"'])")
NAMED_SO = regex(r"[\"']~/?[\"']")
ASSIGNED = regex(r"(?P<name>[A-Za-z_]\w*)=[\"']~(?:/|[\"'])")
USED = regex(r"[\"']?\$\{?(?P<name>[A-Za-z_]\w*)\b(?![^}/\"']*[:/#%,^-][^}]*\})")
EXPANDS = regex(r"\beval\b|~[^\n]{0,20}(?:\$\{?HOME|\$\(echo)|expanduser")
PROGRAMS = ("cd", "pushd", "source", ".", "mkdir", "cp", "mv", "rm", "ls", "cat", "touch", "chmod", "chown", "tar")


@rule("error", symptoms=["cd: ~/*: No such file or directory"])
def quoted_tilde(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and QUOTED.search(source.text) and not EXPANDS.search(source.text):
            yield from _of_script(robot, source)


def _of_script(robot: Robot, source: Source) -> Iterator[Finding]:
    assigned: dict[str, Located] = {}
    for run in robot.scripts.done(source):
        if not isinstance(run, Run):
            continue
        for word in (*run.command.assignments, *run.words[1:]):
            assigned.pop(word.partition("=")[0], None)
            if (given := ASSIGNED.match(word.span.text)) and not _is_set_elsewhere(source, run, given["name"]):
                assigned[given["name"]] = word
        if run.name not in PROGRAMS:
            continue
        for word in run.words[1:]:
            used = USED.match(word.span.text)
            origin = assigned.pop(used["name"], None) if used else None
            if origin is not None:
                yield finding(
                    origin,
                    f"The shell does not expand the quoted '~': {run.name} looks for a folder of that name",
                    advice="write $HOME, which is expanded in double quotes",
                    related=[note(word, "used here")],
                )
            elif QUOTED.match(word.span.text) and not (run.name in ("rm", "mv") and NAMED_SO.fullmatch(word.span.text)):
                yield finding(
                    word,
                    f"The shell does not expand the quoted '~': {run.name} looks for a folder of that name",
                    advice="write $HOME, which is expanded in double quotes",
                )
        if run.name in ("source", ".") and not any("setup." in word for word in run.words):
            assigned.clear()


def _is_set_elsewhere(source: Source, run: Run, name: str) -> bool:
    """Whether a ``for`` sets the variable, too, or it is local to a function and another place sets it."""
    written = re.escape(name)
    others = re.search(rf"\bfor[ \t]+{written}\b", source.text)
    return others is not None or (run.name == "local" and len(re.findall(rf"\b{written}=", source.text)) > 1)
