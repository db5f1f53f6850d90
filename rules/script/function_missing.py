"""A script calls a function that it does not have.

## What it finds
A call of a name with an underscore in a script that has other functions of this kind (`setup_host` beside
`setup_workspace`), where nothing in the tree defines or otherwise names it. Silent in scripts that source files of
others than ROS, for calls with options or with `sudo`, as of programs, and for those whose failure is expected.

## Why it matters on a robot
The function was renamed or removed, and its call was left: "command not found". Under `set -e` the set-up ends there;
without it the step is left out.

## Bad
```sh
setup_workspace() { colcon build; }
setup_host
setup_workspace
```

## Good
```sh
setup_host() { sudo usermod -aG dialout "$USER"; }
setup_workspace() { colcon build; }
setup_host
setup_workspace
```

## When to ignore it
When it is a program of the robot that the tree does not install.

## References
- bash(1), "COMMAND EXECUTION"
"""

import re
from collections.abc import Iterable
from collections.abc import Iterator
from itertools import islice

from bringup_lint.api import Finding
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

DEFINES = regex(r"(?m)^[ \t]*(?:function[ \t]+(?P<word>[\w-]+)|(?P<name>[\w-]+)[ \t]*\([ \t]*\))")
SOURCES = regex(
    r"(?m)^[ \t]*(?:source|\.)[ \t]+(?![^\n]*(?:setup\.(?:ba|z)?sh|\.bashrc|os-release|activate)\b)|\beval\b"
)
NAME = regex(r"[a-z][a-z0-9]*(?:_[a-z0-9]+)+")
PROGRAMS = regex(
    r"(?:wpa|jetson|mosquitto|pg|mysql|catkin|ament|rqt|colcon|fw|flash|nand|lsb|mount|mkfs|gst|xmlrpc)_\w+|create_ap"
    r"|usb_modeswitch\w*|xinput_calibrator|start_x|test_cam"
)
"""Names of programs and of functions of a workspace, which have an underscore as well."""
MOST = 20
READ = 200_000
"""How much of a file is searched for a name."""
ASKED = 100
"""Names of a tree that are looked for in all of its files."""


class Suspect(NamedTuple):
    """A function that a script calls and does not define."""

    source: Source
    name: str
    calls: list[Run]


@rule("warning", symptoms=["*: command not found"])
def function_missing(robot: Robot) -> Iterator[Finding]:
    for each in _alone(robot, islice(_suspects(robot), ASKED)):
        first, *others = each.calls
        yield finding(
            first.words[0],
            f"Nothing defines {each.name}: the shell does not find it, and the step is not done",
            advice="define the function, or remove the call",
            related=[note(other.words[0], "here too") for other in others[:MOST]],
        )


def _suspects(robot: Robot) -> Iterator[Suspect]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or "_" not in source.text:
            continue
        own = {match["word"] or match["name"] for match in DEFINES.finditer(source.text)}
        if len(own) < 2 or source.matches(SOURCES):
            continue
        found: dict[str, list[Run]] = {}
        for run in robot.scripts.done(source):
            if isinstance(run, Run) and run.name not in own and _may_be_function(run):
                found.setdefault(run.name, []).append(run)
        for name, calls in found.items():
            if _is_called_like(name, own) and not any(map(_may_fail, calls)):
                yield Suspect(source, name, calls)


def _may_be_function(run: Run) -> bool:
    """Whether a call looks like one of a function: the shell itself makes it, without options."""
    name = run.name
    if not NAME.fullmatch(name) or PROGRAMS.fullmatch(name) or run.words[0] != name or run.command.words[0] != name:
        return False
    return not any(word.startswith("-") for word in run.words)


def _is_called_like(name: str, own: set[str]) -> bool:
    """Whether a function of the script begins with the same word."""
    return any(each.partition("_")[0] == name.partition("_")[0] for each in own if "_" in each)


def _may_fail(run: Run) -> bool:
    return run.command.hides_errors or run.command.ends == "||"


def _alone(robot: Robot, suspects: Iterable[Suspect]) -> list[Suspect]:
    """Those whose names are nowhere else than where they are called. Each file of the tree is read once."""
    named = ((each, re.compile(rf"(?<![\w-]){re.escape(each.name)}(?![\w-])")) for each in suspects)
    left = [(each, name) for each, name in named if len(name.findall(each.source.uncommented)) <= len(each.calls)]
    for path in robot.tree.paths:
        if not left:
            break
        text = robot.tree.start(path, READ)
        left = [
            (each, name)
            for each, name in left
            if each.name not in text or path == each.source.absolute or not name.search(text)
        ]
    return [each for each, _ in left]
