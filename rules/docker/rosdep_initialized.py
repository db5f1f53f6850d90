"""A step calls rosdep init in an image in which that was done.

## What it finds
`rosdep init` in a stage on an official image of ROS other than `ros-core` (`ros:jazzy`, `ros:humble-ros-base`,
`osrf/ros:jazzy-desktop`), where the failure of the command ends the step. Silent where a step removes or looks for the
list of sources, and where something catches the failure.

## Why it matters on a robot
These images come with the default list of rosdep. `rosdep init` then ends with "default sources list file already
exists" and status 1, and with it the build of the image.

## Bad
```dockerfile
FROM ros:jazzy-ros-base
RUN rosdep init && rosdep update
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
RUN rosdep update
```

## When to ignore it
When the image is built on another one of that name.

## References
- https://github.com/osrf/docker_images, ros-base: `RUN rosdep init && rosdep update`
- https://github.com/ros-infrastructure/rosdep/issues/48
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Instruction
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.docker import ros_distro
from bringup_lint.api.shell import unwrapped

CORE = regex(r"ros-core|ros1-bridge")
LISTS = regex(
    r"sources\.list\.d/(?:\*|20-default)|/etc/ros(?![\w-])|\bROSDEP_SOURCE_PATH\b|\bset[ \t]+\+e\b"
    r"|![ \t]+(?:sudo[ \t]+)?rosdep\b"
)
"""What makes room for the list, or looks for it."""


@rule("error", symptoms=["default sources list file already exists"])
def rosdep_initialized(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if "rosdep" not in file.source.text or LISTS.search(file.source.text):
            continue
        for stage in file.stages:
            if (
                not ros_distro(stage.origin)
                or CORE.search(stage.origin)
                or robot.compose.images.is_chosen(stage, tag=True)
            ):
                continue
            word = next((word for each in stage.all("RUN") if (word := _called(each)) is not None), None)
            if word is not None:
                yield finding(
                    word,
                    f"{stage.origin} comes with the list of rosdep: this ends with status 1, and the build with it",
                    advice="leave rosdep init out, and keep rosdep update",
                    related=[note(list(stage.chain)[-1].image, "the image")],
                )


def _called(step: Instruction) -> Located | None:
    """The call of a step that ends with its failure."""
    if step.heredocs:
        return None
    commands = list(commands_of_run(step))
    for at, command in enumerate(commands):
        words = unwrapped(command.words)
        if [str(word) for word in words[:2]] == ["rosdep", "init"] and not command.depth:
            follow = [each.ends for each in commands[at:]]
            if all(ends in ("&&", "") for ends in follow):
                return words[0]
    return None
