"""The base image is not pinned.

## What it finds
FROM without a tag, or with `:latest`. Digests, earlier stages, `scratch` and variables are not reported, and neither
are images that the tree builds, or that no registry can hold (a name without a namespace that is not an official
image). One image is one finding, however many Dockerfiles build on it. It is info for stages from which files are
only copied, for images without ROS that install no packages of a distribution, and for images that a robot hardly runs
by themselves.

## Why it matters on a robot
The next build uses another Ubuntu, another ROS or another compiler, although nothing in the repository has changed.

## Bad
```dockerfile
FROM ros
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
```

## When to ignore it
When the image is only for development or CI and should follow the newest base image.

## References
- robotics-security guide, container hardening
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Dockerfile
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import can_be_pulled
from bringup_lint.api.docker import holds_ros
from bringup_lint.api.docker import image_name
from bringup_lint.api.docker import is_deployed

DISTRIBUTION = regex(r"(?:ubuntu|debian|fedora|alpine|archlinux)")
INSTALLS = regex(r"\b(?:apt|apt-get|dnf|yum|pacman)\b|\bapk[ \t]+add\b")


@rule("warning", silent="the build takes whatever image it finds under the tag")
def no_pin(robot: Robot) -> Iterator[Finding]:
    bases: dict[str, list[Located]] = {}
    kept: set[str] = set()
    for file in robot.dockerfiles:
        for stage in file.stages:
            if stage.base is None and file.source.judged and _is_pulled(robot, stage.resolved):
                bases.setdefault(stage.resolved, []).append(stage.image)
                if _is_kept(robot, file, stage):
                    kept.add(stage.resolved)
    for name, (first, *others) in bases.items():
        yield finding(
            first,
            f"The base image '{name}' is not pinned: the next build may use another one",
            advice="name a version tag or a digest",
            related=[note(other, "the same image") for other in others[:20]],
            severity=None if name in kept else "info",
        )


def _is_kept(robot: Robot, file: Dockerfile, stage: Stage) -> bool:
    """Whether the image becomes part of one that a robot may run, rather than of a stage from which files are taken."""
    final = file.final
    if final is None or stage not in final.chain or not is_deployed(robot.compose, file):
        return False
    is_distribution = DISTRIBUTION.fullmatch(image_name(stage.resolved).repository) is not None
    return holds_ros(final) or (is_distribution and _installs(file))


def _installs(file: Dockerfile) -> bool:
    """Whether a stage takes packages, which only some releases of a distribution have."""
    return any(INSTALLS.search(run.value) for stage in file.stages for run in stage.all("RUN"))


def _is_pulled(robot: Robot, image: str) -> bool:
    """Whether a build takes whatever the registry has at that time."""
    if image == "scratch" or "$" in image or not image_name(image).is_latest or not can_be_pulled(image):
        return False
    return not robot.compose.images.is_built(image)
