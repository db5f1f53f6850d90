"""An image of one ROS distribution, and a command that names another.

## What it finds
In an image that is built on `ros:DISTRO` or `osrf/ros:DISTRO`:
- a step, `ENTRYPOINT` or `CMD`, a compose `command` or the entry script that uses `/opt/ros/OTHER`;
- `COPY --from` of a workspace that a stage of another distribution built.

Silent in images that install packages of the other distribution, or copy its folder.

## Why it matters on a robot
After an upgrade half of the files still name the old release. The file does not exist in the image: with `set -e` the
container ends at once and restarts forever, and without it no package is found. Libraries that another release built do
not load.

## Bad
```dockerfile
FROM ros:jazzy-ros-base
RUN . /opt/ros/humble/setup.sh && colcon build
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
RUN . /opt/ros/$ROS_DISTRO/setup.sh && colcon build
```

## When to ignore it
When a step that is not seen here brings the other distribution.

## References
- https://hub.docker.com/_/ros
- REP 2000, releases and target platforms
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
from bringup_lint.api.docker import Runner
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of

IMAGE = regex(
    r"(?:docker\.io/)?(?:library/)?(?:(?:arm64v8|amd64|arm32v7)/)?(?:osrf/)?ros:(?P<distro>[a-z]+)(?:-[\w.-]+)?"
)
NAMED = regex(r"/opt/ros/(?P<distro>[a-z]+)(?=/|$)")
TESTS = ("[", "[[", "test")
BUILDS = regex(r"\bcolcon\s+build\b")
LIBRARIES = regex(r"(?:^|/)install/?$|^/opt/(?!ros/)")


@rule("error", symptoms=["/opt/ros/*/setup.bash: No such file or directory"])
def ros_distro_mismatch(robot: Robot) -> Iterator[Finding]:
    found: dict[tuple[Source, str, str], list[tuple[Located, Stage]]] = {}
    for file in robot.dockerfiles:
        for stage in file.stages:
            for word, other in _of_steps(stage):
                found.setdefault((word.span.source, _distro(stage), other), []).append((word, stage))
            yield from _copied(stage, {each.name.lower(): each for each in file.stages if each.name})
    for runner in robot.runners.all:
        if runner.stage is not None:
            for word, other in _of_runner(runner, runner.stage):
                found.setdefault((word.span.source, _distro(runner.stage), other), []).append((word, runner.stage))
    for (_, distro, other), places in found.items():
        words = list(dict.fromkeys(word for word, _ in places))
        yield finding(
            words[0],
            f"The image is one of {distro}: there is no /opt/ros/{other} in it",
            advice="write /opt/ros/$ROS_DISTRO",
            related=[
                *(note(word, "here too") for word in words[1:20]),
                note(places[0][1].start.value, f"the image of {distro}"),
            ],
        )


def _distro(stage: Stage) -> str:
    match = IMAGE.fullmatch(stage.origin)
    return match["distro"] if match is not None else ""


def _lacks(stage: Stage, other: str) -> bool:
    """Whether no step brings another distribution."""
    own = _distro(stage)
    if not own or other == own:
        return False
    brings = re.compile(rf"\bros-{other}-|\b{other}\b[^\n]*(?:tar|curl|wget|git)|--from=\S+[^\n]*/opt/ros")
    return not any(brings.search(text) for text in _texts(stage))


def _texts(stage: Stage) -> Iterator[str]:
    """What brings files into an image."""
    for each in stage.chain:
        for instruction in each.all("RUN", "COPY", "ADD"):
            yield " ".join((*instruction.flags, instruction.value))


def _of_steps(stage: Stage) -> Iterator[tuple[Located, str]]:
    for command in commands_of(stage):
        if command.depth or command.ends == "||":
            continue
        for word in command.words:
            match = NAMED.match(word)
            if match is not None and _lacks(stage, match["distro"]):
                yield word, match["distro"]


def _of_runner(runner: Runner, stage: Stage) -> Iterator[tuple[Located, str]]:
    for line in runner.lines:
        tested = False
        for step in line.steps:
            command = step.command
            if (
                command.name in ("source", ".")
                and not tested
                and not command.depth
                and command.ends not in ("||", "&&")
            ):
                for word in command.words[1:2]:
                    match = NAMED.match(word)
                    if match is not None and _lacks(stage, match["distro"]):
                        yield word, match["distro"]
            tested = command.ends == "&&" and command.name in TESTS


def _copied(stage: Stage, named: dict[str, Stage]) -> Iterator[Finding]:
    """Workspaces that a stage of another distribution built."""
    for instruction in stage.all("COPY"):
        origin = next((flag.removeprefix("--from=") for flag in instruction.flags if flag.startswith("--from=")), "")
        other = named.get(origin.lower())
        if other is None or not _distro(other) or not _distro(stage) or _distro(other) == _distro(stage):
            continue
        built = any(BUILDS.search(str(each.value)) for link in other.chain for each in link.all("RUN"))
        words = list(instruction.value.words())
        if built and any(LIBRARIES.search(word) for word in words[:-1]):
            yield finding(
                words[0],
                f"This workspace is built on {_distro(other)}, and the image is one of {_distro(stage)}: "
                "its libraries do not load",
                advice="write the same distribution in both stages",
                related=[note(other.start.value, "builds it"), note(stage.start.value, "runs it")],
            )
