"""The container runs as root.

## What it finds
A last stage with `USER root` as its last USER, or without USER on an image that certainly runs as root (the
official ROS, Ubuntu, Debian and Python images). Builder stages are not checked. Files that mention gosu, su-exec,
setpriv, runuser or fixuid are not reported, because they drop privileges.

## Why it matters on a robot
An intruder in one node is root in the container. If the host uses another user, Fast DDS's shared memory cannot be
opened from both sides: topics are listed, but no data arrives.

## Bad
```dockerfile
FROM ros:jazzy
CMD ["ros2", "launch", "base", "base.launch.py"]
```

## Good
```dockerfile
FROM ros:jazzy
RUN useradd --system robot
USER robot
CMD ["ros2", "launch", "base", "base.launch.py"]
```

## When to ignore it
When every deployment sets `user:` or `--user` for this image.

## References
- robotics-security guide, container hardening
- CWE-250
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.docker import runs_as_root

DROPS = re.compile(r"\b(?:gosu|su-exec|setpriv|runuser|fixuid)\b")


@rule("error", tags=["CWE-250"])
def root_user(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        stage = file.final
        if stage is None or DROPS.search(file.source.text):
            continue
        user = stage.last("USER")
        if user is not None and user.value.partition(":")[0] in ("root", "0"):
            yield finding(user.value, "The container runs as root", advice="end with USER and an unprivileged user")
        elif user is None and runs_as_root(stage.origin):
            yield finding(
                stage.start.keyword,
                f"The container runs as root: {stage.origin} sets no USER, and neither does this file",
                advice="create a user and end the file with USER",
            )
