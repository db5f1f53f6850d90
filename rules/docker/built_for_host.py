"""An image is always for the processor of the computer that builds it.

## What it finds
`--platform=$BUILDPLATFORM` at the FROM of a stage that is the image itself, or that it builds on: the last stage of the
Dockerfile, and those that a compose file or a build command of the tree names as target. Silent where the stage
installs compilers for another processor or begins with `scratch`.

It is an info where nothing of the tree builds for another platform.

## Why it matters on a robot
The flag is for stages that only compile, and from which COPY --from takes the result. With
`docker buildx build --platform linux/arm64` on a PC the image is marked as one for arm64 and holds programs for amd64:
on the robot it ends with "exec format error".

## Bad
```dockerfile
FROM --platform=$BUILDPLATFORM ros:jazzy-ros-base
COPY install /opt/rover
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
COPY install /opt/rover
```

## When to ignore it
When the image is for tools that run on the computer that builds it.

## References
- https://docs.docker.com/build/building/multi-platform/#cross-compilation
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

CROSS = regex(r"\bg(?:cc|\+\+)-(?:\d+-)?(?:aarch64|arm|riscv64|x86-64)-linux-gnu|\bcrossbuild-essential-")
"""Compilers for another processor, in an image that only compiles."""
OTHER_PLATFORMS = regex(
    r"--platform[ =]+[\"']?linux/|\bplatforms?:[ \t]*(?:\n[ \t]*-[ \t]*)?(?:[\"'\[][\"'\[ ]*)?linux/|\bbinfmt\b"
    r"|setup-qemu|qemu-user-static",
    hints="linux/ binfmt qemu",
)
"""What builds or runs images for another platform than that of the computer."""


@rule("warning", symptoms=["exec format error"])
def built_for_host(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        seen = set()
        images = [each for each in file.stages if each is file.final or each in robot.compose.built_stages]
        images = [each for each in images if not any(CROSS.search(run.value) for run in each.all("RUN"))]
        for image in images:
            for stage in image.chain:
                flag = next((each for each in stage.start.flags if "BUILDPLATFORM" in each), None)
                if flag is None or flag.span in seen or stage.origin == "scratch":
                    continue
                seen.add(flag.span)
                yield finding(
                    flag,
                    "This image gets the programs of the computer that builds it, whatever platform it is built for",
                    advice="leave --platform out of the stages of which the image consists",
                    related=[] if stage is image else [note(image.start.value, "the image builds on it")],
                    severity=None if robot.mentions(OTHER_PLATFORMS) else "info",
                )
