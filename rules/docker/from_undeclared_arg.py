"""FROM uses an ARG that is not declared before the first FROM.

## What it finds
Variables in `FROM` that no `ARG` before the first `FROM` declares, where the name of the image is not valid without
them. The variables of the platform (`BUILDPLATFORM`, `TARGETARCH` and the like) and those with a default are known.

## Why it matters on a robot
The variable is empty, whatever `--build-arg` says, and the build stops with "invalid reference format". An `ARG` inside
a stage holds for that stage alone.

## Bad
```dockerfile
FROM ros:${ROS_DISTRO}
ARG ROS_DISTRO=jazzy
```

## Good
```dockerfile
ARG ROS_DISTRO=jazzy
FROM ros:${ROS_DISTRO}
```

## When to ignore it
When a tool puts the declaration in front of the file before it is built.

## References
- https://docs.docker.com/reference/dockerfile/#understand-how-arg-and-from-interact
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

VARIABLE = regex(r"\$(?:\{(\w+)\}|(\w+))")
PLATFORM = regex(r"(?:BUILD|TARGET)(?:PLATFORM|OS|ARCH|VARIANT)")


@rule(
    "error",
    symptoms=[
        "invalid reference format",
        "base name",
        "should not be blank",
        "UndefinedArgInFrom: FROM argument * is not declared",
        "InvalidDefaultArgInFrom: Default value for ARG * results in empty or invalid base image name",
    ],
)
def from_undeclared_arg(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if not file.stages:
            continue
        before = file.source.text[: file.stages[0].start.keyword.span.start]
        for stage in file.stages:
            names = [braced or plain for braced, plain in VARIABLE.findall(stage.image)]
            lacking = [name for name in names if not PLATFORM.fullmatch(name) and not _is_named(name, before)]
            rest = VARIABLE.sub("", stage.image)
            if names and lacking == names and "$" not in rest and (not rest or rest.endswith((":", "/", "@"))):
                yield finding(
                    stage.image,
                    f"{lacking[0]} is not declared before the first FROM: it is empty and the build stops",
                    advice=f"write ARG {lacking[0]} above the first FROM",
                )


def _is_named(name: str, text: str) -> bool:
    return re.search(rf"\b{re.escape(name)}\b", text) is not None
