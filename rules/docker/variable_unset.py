"""An image uses a variable that nothing sets.

## What it finds
`$HOME`, `$USER` and other variables in ENV, WORKDIR, COPY, ADD and USER, and in the names of packages that a RUN
installs, where neither ENV nor ARG of the Dockerfile sets them, and the base image is an official one that does not.
A variable with a default, and one that is added to itself (`PATH`), is not meant.

On any image, a variable anywhere in the file that differs in one letter from an ENV or ARG of it, where nothing else in
the tree has this name, or nothing in the file reads that ENV or ARG: a letter is left out, there twice, the one beside
it on the keyboard, or exchanged with the next.

## Why it matters on a robot
Docker itself replaces the variables of these instructions, and knows only those of ENV and ARG, not those of the shell.
It puts nothing in the place of any other: `ENV WS=$HOME/ws` becomes `/ws`, and apt looks for `ros--nav2-bringup`.

## Bad
```dockerfile
FROM ubuntu:22.04
ENV ROVER_WS=$HOME/rover_ws
RUN apt-get update && apt-get install -y ros-$ROS_DISTRO-nav2-bringup
```

## Good
```dockerfile
FROM ubuntu:22.04
ENV ROVER_WS=/root/rover_ws
ENV ROS_DISTRO=humble
RUN apt-get update && apt-get install -y ros-$ROS_DISTRO-nav2-bringup
```

## When to ignore it
When the empty value is meant.

## References
- https://docs.docker.com/reference/dockerfile/#environment-replacement
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Dockerfile
from bringup_lint.api.docker import Instruction
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import assignments
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.docker import may_set
from bringup_lint.api.spelling import Neighbours
from bringup_lint.api.spelling import is_slip
from bringup_lint.api.spelling import numbered

REPLACED = ("WORKDIR", "COPY", "ADD", "USER")
USED = regex(r"(?<![\\$])\$(?:(?P<plain>[A-Za-z_]\w*)|\{(?P<braced>[A-Za-z_]\w*)\})", hints="$")
PACKAGE = regex(r"ros-(?:\$[A-Za-z_]\w*|\$\{[A-Za-z_]\w*\})-[\w.+-]+", hints="ros-$")
GIVEN = regex(r"(?:https?|ftp|no|all)_proxy|PATH|TARGET\w+|BUILD(?:PLATFORM|OS|ARCH|VARIANT)", re.I)
"""What Docker itself sets or takes."""
SETS = regex(r"(?:^|[\s;&(])(?:source|\.|eval|read|for|export|while)[ \t]")
INSTALLERS = ("apt", "apt-get")
MOST = 20
SIZE = 200_000
COMMENT = regex(r"^[ \t]*#")


class Use(NamedTuple):
    name: str
    where: Located


@rule("warning", symptoms=["E: Unable to locate package ros--*", "UndefinedVar: Usage of undefined variable *"])
def variable_unset(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if "$" not in file.source.text:
            continue
        is_read = file.source.judged and not file.source.template and len(file.source.text) <= SIZE
        misspelt = dict(_misspelt(robot, file)) if is_read else {}
        yield from misspelt.values()
        declared = (name for stage in file.stages for name in _declared(stage))
        elsewhere = {*file.arguments, *declared, *misspelt}
        for stage in file.stages:
            if any(one not in file.stages for one in stage.chain):
                continue
            unset = [use for use in _uses(stage) if _is_unset(stage, use.name, elsewhere)]
            if unset:
                yield _report(file, unset)


def _misspelt(robot: Robot, file: Dockerfile) -> Iterator[tuple[str, Finding]]:
    """The variables that differ in a letter from one of the file, and those of the file that differ from one that it
    reads."""
    source = file.source
    declared = {*file.arguments, *(name for stage in file.stages for name in _declared(stage))}
    used = [match for match in USED.finditer(source.text) if not COMMENT.search(source.line_before(match.start()))]
    read = {match["plain"] or match["braced"]: match for match in reversed(used)}
    slips = Neighbours(declared)
    for name, match in read.items():
        if name not in declared:
            meant = [each for each in slips.meant(name) if _is_slip(name, each)]
            known = bool(meant) and meant[0] in read and _is_elsewhere(robot, file, name)
            if meant and not known and not _is_set(file, name):
                said = f"Nothing sets {name} in this image: it is empty here"
                yield name, finding(source.located(*match.span()), said, advice=f"did you mean {meant[0]}?")
    slips = Neighbours(name for name in read if name in declared)
    for place in (word for stage in file.stages for one in stage.all("ARG") for word in one.value.words()):
        name = str(place).partition("=")[0]
        meant = [each for each in slips.meant(name) if _is_slip(name, each)]
        if meant and source.text.count(name) == 1 and not _is_elsewhere(robot, file, name):
            said = f"Nothing reads {name} in this image: whatever it is given has no effect"
            yield name, finding(place.part(0, len(name)), said, advice=f"did you mean {meant[0]}?")


def _is_slip(name: str, meant: str) -> bool:
    """Whether one is the other misspelt, and not several of them or another of several."""
    return is_slip(name, meant) and name.rstrip("sS") != meant.rstrip("sS") and not numbered(name, meant)


def _is_set(file: Dockerfile, name: str) -> bool:
    """Whether the file has the name but where it reads it."""
    written = re.escape(name)
    return re.search(rf"(?<![$\w{{]){written}\b|\$\{{{written}:?[-=+?]", file.source.text) is not None


def _is_elsewhere(robot: Robot, file: Dockerfile, name: str) -> bool:
    """Whether another file has the name."""
    alone = re.compile(rf"(?<!\w){re.escape(name)}(?!\w)")
    others = (each for each in robot.sources if each is not file.source)
    return any(name in each.text and alone.search(each.text) for each in others)


def _report(file: Dockerfile, unset: list[Use]) -> Finding:
    first, *others = unset
    return finding(
        first.where,
        f"Nothing sets {first.name} in this image: docker puts nothing in its place",
        advice="write the value itself, or set the variable with ENV or ARG above",
        related=[note(other.where, f"{other.name} is empty, too") for other in others[:MOST]],
    )


def _declared(stage: Stage) -> Iterator[str]:
    for instruction in stage.all("ARG"):
        yield from (str(word).partition("=")[0] for word in instruction.value.words())
    for instruction in stage.all("ENV"):
        yield from (name for name, _ in assignments(instruction))


def _is_unset(stage: Stage, name: str, elsewhere: set[str]) -> bool:
    """Whether no image below sets a variable. One of another stage or above FROM is for docker/arg-out-of-scope."""
    if name in elsewhere or GIVEN.fullmatch(name) or stage.earlier:
        return False
    return "$" not in stage.origin and not may_set(stage.origin, name)


def _uses(stage: Stage) -> Iterator[Use]:
    for instruction in stage.all("ENV"):
        for name, value in assignments(instruction):
            yield from (use for use in _in(value) if use.name != name)
    for instruction in stage.all(*REPLACED):
        yield from _in(instruction.value)
        yield from (use for flag in instruction.flags for use in _in(flag))
    for instruction in stage.all("RUN"):
        yield from _packages(instruction)


def _in(value: Located) -> Iterator[Use]:
    for match in USED.finditer(value):
        where = value.part(*match.span())
        if where.span.source.line_before(where.span.start).count("'") % 2 == 0:
            yield Use(match["plain"] or match["braced"], where)


def _packages(instruction: Instruction) -> Iterator[Use]:
    """The variables in the names of packages, in a step that cannot set them itself."""
    if SETS.search(instruction.value):
        return
    for command in commands_of_run(instruction):
        if any(name in command.words for name in INSTALLERS) and not command.assignments:
            for word in command.words:
                if PACKAGE.fullmatch(word):
                    yield from _in(word)
