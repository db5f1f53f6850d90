"""The base image is not pinned.

## What it finds
FROM without a tag, or with `:latest`. Digests, earlier stages, `scratch` and variables are not reported.

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
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning")
def no_pin(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        for stage in file.stages:
            image = stage.resolved
            if stage.base is not None or image == "scratch" or "@" in image or "$" in image:
                continue
            tag = image.rpartition("/")[2].partition(":")[2]
            if tag in ("", "latest"):
                yield finding(
                    stage.image,
                    f"The base image '{image}' is not pinned: the next build may use another one",
                    advice="name a version tag or a digest",
                )
