"""apt installs a package in an image that has no package lists.

## What it finds
`apt-get install` and `apt install` in a stage where no step before it ran `apt-get update`, or where a step removed
`/var/lib/apt/lists` since, for images that come without lists: `ros`, `osrf/ros`, `ubuntu`, `debian`, `python` and
NVIDIA's. `rosdep install` where no step of the image ever ran `apt-get update` is a warning, because what it needs may
be there already; `rosdep update` fetches other lists.

Silent after a step that may update the lists in a way that is not seen: a script, `add-apt-repository`, a program that
is piped into a shell, and a cache that is mounted at `/var/lib/apt`. A setup file of ROS or of a workspace updates
nothing.

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

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.docker import first_unlisted


@rule("error", confidence="medium", symptoms=["E: Unable to locate package", "has no installation candidate"])
def apt_without_update(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if "apt" not in file.source.text:
            continue
        for stage in file.stages:
            unlisted = first_unlisted(stage)
            if unlisted is None or robot.compose.images.is_chosen(stage, tag=False):
                continue
            package, removed = unlisted
            why = "they were removed before" if removed is not None else f"{stage.origin} comes without them"
            asked = package == "rosdep"
            missed = "nothing that rosdep asks for" if asked else f"no {package}"
            yield finding(
                package,
                f"There are no package lists at this step ({why}): apt finds {missed}, and the build stops",
                advice="run apt-get update in the same step",
                related=[note(removed, "removes the lists")] if removed is not None else (),
                severity="warning" if asked else None,
            )
