"""An image uses a variable that nothing sets.

## What it finds
`$HOME`, `$USER` and other variables in ENV, WORKDIR, COPY, ADD and USER, and in the names of packages that a RUN
installs, where neither ENV nor ARG of the Dockerfile sets them, and the base image is an official one that does not.
A variable with a default, and one that is added to itself (`PATH`), is not meant.

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

REPLACED = ("WORKDIR", "COPY", "ADD", "USER")
USED = regex(r"(?<![\\$])\$(?:(?P<plain>[A-Za-z_]\w*)|\{(?P<braced>[A-Za-z_]\w*)\})", hints="$")
PACKAGE = regex(r"ros-(?:\$[A-Za-z_]\w*|\$\{[A-Za-z_]\w*\})-[\w.+-]+", hints="ros-$")
GIVEN = regex(r"(?:https?|ftp|no|all)_proxy|PATH|TARGET\w+|BUILD(?:PLATFORM|OS|ARCH|VARIANT)", re.I)
"""What Docker itself sets or takes."""
SETS = regex(r"(?:^|[\s;&(])(?:source|\.|eval|read|for|export|while)[ \t]")
INSTALLERS = ("apt", "apt-get")
MOST = 20


class Use(NamedTuple):
    name: str
    where: Located


@rule("warning", symptoms=["E: Unable to locate package ros--*", "UndefinedVar: Usage of undefined variable *"])
def variable_unset(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if "$" not in file.source.text:
            continue
        elsewhere = {*file.arguments, *(name for stage in file.stages for name in _declared(stage))}
        for stage in file.stages:
            if any(one not in file.stages for one in stage.chain):
                continue
            unset = [use for use in _uses(stage) if _is_unset(stage, use.name, elsewhere)]
            if unset:
                yield _report(file, unset)


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
