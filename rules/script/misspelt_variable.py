"""A script deletes below a variable that has another name where it is set.

## What it finds
`$NAME` or `${NAME}` before a `/` in `rm -r`, where neither the script nor any other file of the tree sets NAME, and
the script sets a variable whose name is nearly the same.

Silent where the script sources files, reads variables with `read`, `eval` or `export $(...)`, tests whether NAME is
set, or runs under `set -u`.

## Why it matters on a robot
The shell puts nothing in the place of a variable that is not set: `rm -rf $LOGDIR/*` becomes `rm -rf /*`, and as root
that deletes the robot.

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
from bringup_lint.api.spelling import nearest

USED = regex(r"[\"']?\$(?:\{(?P<braced>[A-Za-z_]\w*)\}|(?P<plain>[A-Za-z_]\w*))[\"']?/")
RECURSIVE = regex(r"-[a-zA-Z]*[rR][a-zA-Z]*|--recursive")
LEARNS = regex(
    r"(?m)(?:^|[;&|({]|\b(?:then|do|else))[ \t]*(?:source|\.|eval)[ \t]|^#![^\n]{0,80}[ \t]-[a-z]{0,8}u|\bnounset\b"
    r"|^[ \t]*set[ \t][^\n]{0,60}-[a-z]{0,8}u|\b(?:export|declare|readonly)[ \t]+[\"']?[$`]"
)
GIVEN = frozenset("HOME PWD OLDPWD USER TMPDIR DESTDIR WORKSPACE TARGET_DIR ROOTFS_DIR ROS_HOME ROS_LOG_DIR".split())
"""Variables that a login, a build or ROS gives."""
ASSIGNED = regex(r"[A-Za-z_]\w*(?==)")


@rule("error", confidence="medium", symptoms=["rm: it is dangerous to operate recursively on '/'"])
def misspelt_variable(robot: Robot) -> Iterator[Finding]:
    for source, run in robot.scripts.run("rm"):
        if not any(map(RECURSIVE.fullmatch, run.words)) or LEARNS.search(source.text):
            continue
        for word in run.words[1:]:
            used = USED.match(word.span.text)
            name = (used["braced"] or used["plain"]) if used else ""
            if not name or name in GIVEN or word.span.text.startswith("'") or _may_be_set(robot, source, name):
                continue
            assigned = _assigned(robot, source)
            meant = nearest(name, assigned)
            if meant:
                yield finding(
                    word,
                    f"Nothing sets {name}: this deletes '{word[word.index('/') :]}'",
                    advice=f"write ${{{meant[0]}:?}}, which stops the script where it is empty",
                    related=[note(assigned[meant[0]], "this is set")],
                )


def _may_be_set(robot: Robot, source: Source, name: str) -> bool:
    """Whether the name is anywhere but where its value is used, or in another file."""
    others = (each for each in robot.sources if each is not source)
    written = re.escape(name)
    set_here = rf"(?<![$\w{{]){written}\b|\$\{{[!#]?{written}[^\w}}]"
    tested = rf"(?:\[|\btest)[ \t][^\n]{{0,100}}\$\{{?{written}\b[^\n]{{0,100}}(?:\]|&&|\|\|)"
    return re.search(f"{set_here}|{tested}", source.text) is not None or any(name in each.text for each in others)


def _assigned(robot: Robot, source: Source) -> dict[str, Located]:
    """The variables that a script sets."""
    runs = (did for did in robot.scripts.done(source) if isinstance(did, Run))
    words = (word for run in runs for word in (*run.command.assignments, *run.words[1:]))
    return {found[0]: word for word in words if (found := ASSIGNED.match(word))}
