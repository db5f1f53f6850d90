"""A Dockerfile or a compose file names a stage that the Dockerfile does not have.

## What it finds
`COPY --from=` and `FROM` with a name that no stage above has, and that differs in one letter from that of a stage of
the file, or is that of no official image of Docker Hub and no image that anything of the tree makes or speaks of (a
warning). And `target:` of a compose service whose Dockerfile has no stage of that name, whatever the stages are called.

## Why it matters on a robot
Docker takes the name for that of an image, which nobody has: "pull access denied, repository does not exist". Nothing
is built. A missing target ends the build with "target stage could not be found".

## Bad
```dockerfile
FROM ros:jazzy-ros-base AS builder
RUN make -C /ws
FROM ros:jazzy-ros-core
COPY --from=bulder /ws/install /ws/install
```

## Good
```dockerfile
FROM ros:jazzy-ros-base AS builder
RUN make -C /ws
FROM ros:jazzy-ros-core
COPY --from=builder /ws/install /ws/install
```

## When to ignore it
When an image or a build context of this name exists.

## References
- https://docs.docker.com/build/building/multi-stage/
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Dockerfile
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import UnknownImage
from bringup_lint.api.docker import unknown_images
from bringup_lint.api.spelling import Neighbours
from bringup_lint.api.spelling import is_slip
from bringup_lint.api.spelling import numbered

COPIED = regex(r"--from=(?P<name>[A-Za-z][\w-]+)\Z|--mount=(?:[^,]+,){0,9}from=(?P<mount>[A-Za-z][\w-]+)(?:,.*)?\Z")
NAME = regex(r"[A-Za-z][\w-]+")
MOST = 8


@rule("error", symptoms=["pull access denied for *, repository does not exist", "target stage * could not be found"])
def unknown_stage(robot: Robot) -> Iterator[Finding]:
    misspelt: set[Span] = set()
    for file in (file for file in robot.dockerfiles if file.source.judged and not file.source.template):
        for found in _misspelt(file):
            misspelt.add(found.span)
            yield found
    for unknown in unknown_images(robot.compose):
        if unknown.where.span not in misspelt:
            yield _of_nobody(unknown)
    if robot.of_kind("compose"):
        yield from _missing_targets(robot)


def _of_nobody(unknown: UnknownImage) -> Finding:
    return finding(
        unknown.where,
        f"No stage above and nothing that is built here is called '{unknown.name}', and Docker Hub has no such image",
        advice="name the stage that is meant, or add what builds the image: docker build -t NAME",
        related=[note(unknown.last, "the stage above")] if unknown.last is not None else (),
        severity="warning",
    )


def _missing_targets(robot: Robot) -> Iterator[Finding]:
    missing = robot.compose.images.missing_targets()
    for target, file in (each for each in missing if each[0].span.source.judged and not each[1].source.template):
        names = ", ".join(str(stage.name) for stage in file.stages[:MOST] if stage.name is not None)
        yield finding(
            target,
            f"{file.source.basename} has no stage '{target}': the image is not built",
            advice=f"its stages are {names}" if names else "it names no stage",
            related=[note(file.stages[-1].start.keyword, "the last stage")],
        )


def _misspelt(file: Dockerfile) -> Iterator[Finding]:
    """The names that differ in a letter from that of a stage above."""
    above: dict[str, Located] = {}
    for stage in file.stages:
        for place in _named(stage):
            if file.stage(place) is None:
                for meant in Neighbours(above).meant(place.lower()):
                    if is_slip(place.lower(), meant) and not numbered(place, meant):
                        yield finding(
                            place,
                            f"No stage is called '{place}': docker looks for an image of this name, and builds nothing",
                            advice=f"write {above[meant]}",
                            related=[note(above[meant], "the stage")],
                        )
        if stage.name is not None:
            above[stage.name.lower()] = stage.name


def _named(stage: Stage) -> Iterator[Located]:
    """The names in FROM and ``--from=`` that may be those of stages."""
    if NAME.fullmatch(stage.image):
        yield stage.image
    for flag in (flag for instruction in stage.all("COPY", "ADD", "RUN") for flag in instruction.flags):
        if match := COPIED.match(flag):
            yield flag.part(*match.span(match.lastgroup or 0))
