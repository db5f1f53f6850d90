"""apt installs a package in an image that has no package lists.

## What it finds
`apt-get install` and `apt install` in a stage where no step before it ran `apt-get update`, or where a step removed
`/var/lib/apt/lists` since, for images that come without lists: `ros`, `osrf/ros`, `ubuntu`, `debian`, `python` and
NVIDIA's.

Silent after a step that may update the lists in a way that is not seen: a script, `add-apt-repository`, a program that
is piped into a shell, and a cache that is mounted at `/var/lib/apt`.

## Why it matters on a robot
The build ends with "Unable to locate package", on the first machine that has no cached layer: often that is the robot,
or the computer that is to build a fix in the field.

## Bad
```dockerfile
FROM ros:jazzy-ros-base
RUN apt-get install -y ros-jazzy-joy
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
RUN apt-get update && apt-get install -y ros-jazzy-joy && rm -rf /var/lib/apt/lists/*
```

## When to ignore it
When the image is built on another one of that name, which keeps its lists.

## References
- https://docs.docker.com/build/building/best-practices/#apt-get
- https://github.com/docker-library/official-images
"""

from collections.abc import Iterator
from typing import NamedTuple

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

BARE = regex(
    r"(?:docker\.io/)?(?:library/)?(?:(?:arm64v8|amd64|arm32v7)/)?(?:ros|ubuntu|debian|python|osrf/ros2?)(?::[^@]*)?"
    r"|(?:docker\.io/)?nvidia/cuda:.*|nvcr\.io/nvidia/cuda:.*"
)
"""Images that are published without package lists."""
PROGRAMS = ("apt", "apt-get", "aptitude")
UPDATES = ("add-apt-repository", "apt-add-repository", "curl", "wget", "bash", "sh", "source", ".", "python3", "python")
"""What updates the lists itself, or may start what does."""
LISTS = regex(r"/var/lib/apt(?:/lists)?(?:/\*?)?")
CACHED = regex(r"--mount=(?:[^\s=]{1,40}=[^\s,]{0,200},){0,9}(?:target|dst)=/var/lib/apt")
VALUED = ("-t", "-o", "-c", "--target-release", "--option")


class Lists(NamedTuple):
    """What is known of the package lists at a step."""

    missing: bool = False
    removed: Located | None = None
    """The step that removed them."""


@rule("error", confidence="medium", symptoms=["E: Unable to locate package", "has no installation candidate"])
def apt_without_update(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if "apt" not in file.source.text:
            continue
        for stage in file.stages:
            yield from _of_stage(stage)


def _of_stage(stage: Stage) -> Iterator[Finding]:
    lists = Lists(missing=bool(BARE.fullmatch(stage.origin)))
    for each in reversed(list(stage.chain)[1:]):
        for command in _commands(each):
            lists = _after(lists, command)
    for command in _commands(stage):
        word = _installed(command) if lists.missing else None
        if word is not None:
            why = "they were removed before" if lists.removed is not None else f"{stage.origin} comes without them"
            yield finding(
                word,
                f"There are no package lists at this step ({why}): apt finds no {word}, and the build stops",
                advice="run apt-get update in the same step",
                related=[note(lists.removed, "removes the lists")] if lists.removed is not None else (),
            )
            return
        lists = _after(lists, command)


def _commands(stage: Stage) -> Iterator[Command | None]:
    """The commands of a stage in order; None for a step of which the lists come from elsewhere."""
    for instruction in stage.all("RUN"):
        if instruction.exec_form is not None or any(CACHED.match(flag) for flag in instruction.flags):
            yield None
        else:
            yield from commands_of_run(instruction)


def _after(lists: Lists, command: Command | None) -> Lists:
    if command is None:
        return Lists()
    words = unwrapped(command.words)
    name = program_name(words[0]) if words else ""
    if name in PROGRAMS and "update" in words:
        return Lists()
    if name in UPDATES or (words and "/" in words[0] and name not in PROGRAMS):
        return Lists()
    if name == "rm" and not command.depth and command.ends != "||":
        removed = next((word for word in words[1:] if LISTS.fullmatch(word)), None)
        return Lists(True, removed) if removed is not None else lists
    return lists


def _installed(command: Command | None) -> Located | None:
    """The first package that a command takes from the lists, where its failure stops the build."""
    if command is None or command.depth or command.ends in ("||", "|"):
        return None
    words = unwrapped(command.words)
    if not words or program_name(words[0]) not in PROGRAMS:
        return None
    plain = [word for at, word in enumerate(words) if at and not word.startswith("-") and words[at - 1] not in VALUED]
    if not plain or plain[0] != "install" or any("$" in word for word in plain):
        return None
    return next((word for word in plain[1:] if "/" not in word and not word.endswith(".deb")), None)
