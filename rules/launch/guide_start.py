"""A README starts what the package does not have.

## What it finds
Commands of the form `ros2 launch PACKAGE FILE name:=value` and `ros2 run PACKAGE EXECUTABLE` in a README, or a page
that is called after the installation, set-up or start, for packages of the workspace:
- a launch file of which the whole tree has none of this name;
- an executable that the package surely does not install;
- a value that is not among the choices of its argument;
- an argument that the launch file does not declare, nor anything that it includes.

Silent for what stands in angle brackets or capitals for a name, and for launch files that read arguments by names that
are not known.

## Why it matters on a robot
Whoever sets the robot up follows the README. `ros2 launch` answers that the file was not found, or that the value is
not valid, and starts nothing. An argument that nobody reads is worse: the robot starts, and not as it was told.

## Bad
```sh
ros2 launch mower_bringup robot.launch.py     # launch/bringup.launch.py
```

## Good
```sh
ros2 launch mower_bringup bringup.launch.py
```

## When to ignore it
When another repository has the package, too, and the README means that one.

## References
- https://docs.ros.org/en/rolling/Tutorials/Intermediate/Launch/Using-Substitutions.html
"""

import os
import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import LaunchFile
from bringup_lint.api.spelling import nearest_of_few

README = regex(
    r"(?i)(?:^|/)(?:readme|install(?:ation|ing)?|usage|set[_-]?up|bring[_-]?up|quick[_-]?start|getting[_-]?started)"
    r"(?:\.(?:md|rst|txt))?$"
)
STARTS = regex(
    r"\bros2 launch (?P<package>[a-z]\w+) (?P<file>[\w./-]+\.launch(?:\.(?:py|xml|ya?ml))?)(?![\w.{<$*-])"
    r"(?P<rest>(?:[^\n`'\"\\;&|<>#]|\\\n){0,400})"
)
RUNS = regex(r"\bros2 run (?P<package>[a-z]\w+) (?P<name>\w[\w.-]*)(?![\w{<$*/-])")
ARGUMENT = regex(r"(?<!\S)(?P<name>[A-Za-z_]\w*):=(?P<value>[\w./-]+)(?!\S)")
STAND_IN = regex(r"(?i)\b(?:your|my)_|\.\.\.|\bx{3,}\b|[│┃║]")
"""Of a command that is no more than a form, or part of a drawing."""
MOST = 20
_LIKE = 6
"""Letters that differ in names that are alike."""
_MISSPELT = 2
"""Those in one that is misspelt."""


@rule(
    "warning",
    symptoms=[
        "was not found in the share directory of package",
        "provided value '*' is not valid",
        "No executable found",
    ],
)
def guide_start(robot: Robot) -> Iterator[Finding]:
    read = filter(None, map(robot.tree.read, robot.tree.like(README)))
    sources = [source for source in read if source.judged and "ros2 launch" in source.text]
    own = _files(robot) if sources else {}
    for source in sources:
        if not robot.launch.workspace.is_vendored(source):
            yield from _of_page(robot, source, own)


def _files(robot: Robot) -> dict[str, set[str]]:
    """The names of the launch files of each package."""
    found: dict[str, set[str]] = {}
    for file in robot.launch.launch_files:
        owner = robot.launch.workspace.owner(file.source)
        if owner is not None:
            found.setdefault(owner.name, set()).add(file.source.basename)
    return found


def _of_page(robot: Robot, source: Source, own: dict[str, set[str]]) -> Iterator[Finding]:
    workspace = robot.launch.workspace
    lost: dict[tuple[str, str], list[Located]] = {}
    for match in STARTS.finditer(source.text):
        name, file_name = match["package"], match["file"]
        file = robot.launch.named(name, file_name)
        if file is not None:
            yield from _arguments(robot, source, match, file)
        elif name in workspace.packages and not STAND_IN.search(match[0]) and _is_lost(robot, name, file_name):
            lost.setdefault((name, file_name), []).append(source.located(*match.span("file")))
    yield from _executables(robot, source)
    for (name, file_name), (first, *others) in lost.items():
        package = workspace.packages[name]
        near = nearest_of_few(file_name, own.get(name, ()), _LIKE)
        yield finding(
            first,
            f"{name} has no launch file {file_name}: who follows this page starts nothing",
            advice=_advice(file_name, near, "a launch file that it has"),
            related=[note(package.place, f"the package {name}"), *(note(each, "here too") for each in others[:MOST])],
        )


def _executables(robot: Robot, source: Source) -> Iterator[Finding]:
    workspace = robot.launch.workspace
    lost: dict[tuple[str, str], list[Located]] = {}
    for match in RUNS.finditer(source.text):
        package = workspace.packages.get(match["package"])
        name = match["name"].rstrip(".")
        if package is None or STAND_IN.search(match[0]) or any(robot.tree.named(name)):
            continue
        if workspace.lacks(package, name) and not package.made(name):
            start = match.start("name")
            lost.setdefault((package.name, name), []).append(source.located(start, start + len(name)))
    for (owner, name), (first, *others) in lost.items():
        near = nearest_of_few(name, workspace.packages[owner].executables, _LIKE)
        yield finding(
            first,
            f"{owner} has no executable {name}: who follows this page starts nothing",
            advice=_advice(name, near, "an executable that it installs"),
            related=[
                note(workspace.packages[owner].place, f"the package {owner}"),
                *(note(each, "here too") for each in others[:MOST]),
            ],
        )


def _advice(written: str, near: list[str], what: str) -> str:
    """A name that is nearly what is written is meant; another one may need arguments to do what the page says."""
    if len(near) != 1:
        return f"write the name of {what}"
    is_misspelt = bool(nearest_of_few(written, near, _MISSPELT))
    return f"write {near[0]}" if is_misspelt else f"name {what}, such as {near[0]}, with the arguments that it needs"


def _is_lost(robot: Robot, package: str, file_name: str) -> bool:
    """Whether the tree has no file of this name, and its build makes none."""
    return (
        not any(robot.tree.named(os.path.basename(file_name)))
        and not robot.launch.workspace.packages[package].makes_files
    )


def _arguments(robot: Robot, source: Source, match: re.Match[str], file: LaunchFile) -> Iterator[Finding]:
    given = {each["name"]: each for each in ARGUMENT.finditer(source.text, *match.span("rest"))}
    if not given:
        return
    inner = robot.launch.expansion(file)
    where = file.entry or file.source
    for declared in inner.declared:
        argument = given.get(declared.name)
        choices = launch.choices_of(declared.action)
        if argument is not None and choices and argument["value"] not in choices:
            del given[declared.name]
            yield finding(
                source.located(*argument.span("value")),
                f"{declared.name} of {file.source.basename} takes {', '.join(choices)}: launch ends with this value",
                advice="write one of these",
                related=[note(declared.action.span, "declared here")],
            )
    if inner.open or launch.reads_unseen(robot.launch, inner.files):
        return
    known = {each.name for each in inner.declared} | launch.read_in(robot.launch, inner.files) | {*launch.OF_LAUNCH}
    for name in sorted(given.keys() - known):
        near = nearest_of_few(name, known - given.keys(), 3)
        yield finding(
            source.located(*given[name].span("name")),
            f"'{name}' is not an argument of {file.source.basename}: the value is silently ignored",
            advice=f"write {near[0]}" if near else "take it out",
            related=[note(where, "the launch file")],
        )
