"""A stage reads an ARG that is declared before FROM, or in another stage, only.

## What it finds
A step, or another instruction of a stage, with a variable whose `ARG` is above the first FROM, or in an earlier stage
on which it does not build, and that neither the stage nor the images below it declare. Images of Ubuntu and Debian are
known to set no such variable, those of ROS set `ROS_DISTRO` alone, and those of CUDA what begins with `CUDA` or `NV`;
what other images set is not known, but an `ARG` above the first FROM that no FROM and no stage asks for is of no use
whatever they set. Silent for the proxies that Docker declares itself, and in steps that source or
evaluate something, which may set the variable.

## Why it matters on a robot
An ARG above the first FROM is there for FROM only, and one of a stage ends with it. Inside another stage the variable
is empty: `ros-${ROS_DISTRO}-nav2-bringup` becomes `ros--nav2-bringup`, a folder becomes `/`, and a version the newest
one.

## Bad
```dockerfile
ARG ROVER_WS=/opt/rover
FROM ros:jazzy-ros-base
WORKDIR ${ROVER_WS}
```

## Good
```dockerfile
ARG ROVER_WS=/opt/rover
FROM ros:jazzy-ros-base
ARG ROVER_WS
WORKDIR ${ROVER_WS}
```

## When to ignore it
When the empty value is meant.

## References
- https://docs.docker.com/reference/dockerfile/#understand-how-arg-and-from-interact
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Dockerfile
from bringup_lint.api.docker import Instruction
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import assignments
from bringup_lint.api.docker import may_set

READING = ("RUN", "ENV", "WORKDIR", "COPY", "ADD", "USER", "LABEL", "EXPOSE", "VOLUME")
ASSIGNED = (
    r"(?:^|[\s;&(\"'])(?:export\s+|local\s+)?{name}=|\$\{{{name}:?=|\bfor\s+{name}\b"
    r"|\b(?:read|mapfile|readarray|getopts|printf[ \t]+-v)\b[^\n]{{0,80}}\b{name}\b"
)
VARIABLE = regex(r"\$\{?(\w+)")
OF_DOCKER = regex(r"(?i:https?|ftp|no|all)_proxy")
"""Arguments that Docker declares itself."""
SOURCES = regex(r"(?:^|[\s;&(\"'])(?:(?:source|\.|eval)[ \t]+[^\s;&|]|export[ \t]+[\"']?(?:\$\(|`))")
OF_SHELL = ("HOME", "USER", "UID", "EUID", "PATH", "SHELL", "PWD", "HOSTNAME", "DEBIAN_FRONTEND")


@rule("warning", symptoms=["UndefinedVar: Usage of undefined variable *"])
def arg_out_of_scope(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        idle = _idle(file)
        elsewhere: dict[str, Located] = {}
        for stage in file.stages:
            # A stage that may build on an earlier one may have what that declares.
            yield from _of_stage(file, stage, {} if stage.earlier else elsewhere, idle)
            for instruction in stage.all("ARG"):
                elsewhere |= {word.partition("=")[0]: word for word in instruction.value.words()}


def _of_stage(file: Dockerfile, stage: Stage, elsewhere: dict[str, Located], idle: set[str]) -> Iterator[Finding]:
    reading = {
        name: instructions
        for name, instructions in _reading(stage).items()
        if (name in file.arguments or name in elsewhere) and name not in OF_SHELL and not OF_DOCKER.fullmatch(name)
    }
    declared = {name for one in stage.chain for name in _declared(one)} if reading else set()
    for name, instructions in reading.items():
        of_image = may_set(stage.origin, name)
        if name in declared or (of_image and name not in idle):
            continue
        uses = list(_uses(instructions, name))
        if uses:
            first, *others = uses
            is_global = name in file.arguments
            why = "the ARG above the first FROM is there for FROM only" if is_global else "its ARG is in another stage"
            yield finding(
                first,
                f"{name} is empty here{', unless the image below sets it' if of_image else ''}: {why}",
                advice=f"write ARG {name}{'' if is_global else '=...'} after this FROM, too",
                confidence="medium" if of_image else None,
                related=[
                    note(_declaration(file, name) if is_global else elsewhere[name], "declared here"),
                    *(note(other, "empty here, too") for other in others[:9]),
                ],
            )


def _idle(file: Dockerfile) -> set[str]:
    """The ARGs above the first FROM that are there for no FROM, no other such ARG and no stage. Images with ROS set
    its distribution."""
    texts = [stage.start.value for stage in file.stages] + [text for text in file.arguments.values() if text]
    texts += [flag for stage in file.stages for flag in stage.start.flags]
    used = {name for text in texts for name in VARIABLE.findall(text)} | {"ROS_DISTRO"}
    used.update(*map(_declared, file.stages))
    return {name for name, value in file.arguments.items() if value is not None and name not in used}


def _declaration(file: Dockerfile, name: str) -> Located:
    """The place above the first FROM that names an ARG."""
    source = file.source
    found = re.search(rf"(?<![\w$]){re.escape(name)}\b", source.text)
    return source.located(*(found.span() if found else (0, 0)))


def _declared(stage: Stage) -> Iterator[str]:
    """The variables that a stage declares or sets itself."""
    for instruction in stage.all("ARG"):
        yield from (str(word).partition("=")[0] for word in instruction.value.words())
    for instruction in stage.all("ENV"):
        yield from (name for name, _ in assignments(instruction))


def _reading(stage: Stage) -> dict[str, list[Instruction]]:
    """The instructions of a stage that may read a variable."""
    found: dict[str, list[Instruction]] = {}
    for instruction in stage.all(*READING):
        for name in dict.fromkeys(VARIABLE.findall(instruction.value)):
            found.setdefault(name, []).append(instruction)
    return found


def _uses(instructions: list[Instruction], name: str) -> Iterator[Located]:
    """Where instructions read a variable that has no value and no default."""
    written = re.escape(name)
    read = re.compile(rf"(?<![\\$])\$(?:{written}\b|\{{{written}\}})")
    assigned = re.compile(ASSIGNED.format(name=written))
    for instruction in instructions:
        value = instruction.value
        if instruction.name == "RUN" and (instruction.heredocs or assigned.search(value) or SOURCES.search(value)):
            continue
        match = next((each for each in read.finditer(value) if not _is_quoted(value, each.start())), None)
        if match is not None:
            yield value.part(*match.span())


def _is_quoted(text: str, at: int) -> bool:
    """Whether a place is in single quotes, as far as their number says it."""
    return text.count("'", 0, at) % 2 == 1
