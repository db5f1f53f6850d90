"""An image is not pinned.

## What it finds
An `image:` without a tag, or with `:latest`, that the same service does not build. Digests and variables are not
reported.

## Why it matters on a robot
The next `docker compose pull` brings another ROS, another driver or another message definition to one robot of the
fleet, although nothing in the repository has changed.

## Bad
```yaml
nav:
  image: robot/nav:latest
```

## Good
```yaml
nav:
  image: robot/nav:2.3.1
```

## When to ignore it
When the file is only for development, and the robots run a pinned image.

## References
- robotics-security guide, container hardening
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning")
def latest(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.services:
        image = service.body.scalar("image")
        if image is None or service.build is not None or "$" in image.value or "@" in image.value:
            continue
        tag = image.value.rpartition("/")[2].partition(":")[2]
        if tag in ("", "latest"):
            yield finding(
                image.value,
                f"The image '{image.value}' is not pinned: the next pull may bring another one",
                advice="name a version tag or a digest",
            )
