"""A service opens a file in another folder than the one in which it is mounted.

## What it finds
A file of the tree that `volumes:` mounts in the container, where nothing of the service names its path there, and its
command or environment names a file of the same name in another folder, to which no volume brings one. The mount gives
the file this name, or the image certainly has none of it.

## Why it matters on a robot
The program does not find its file: it ends at once, and the container restarts without an end, or it runs with the
defaults of another robot.

## Bad
```yaml
services:
  driver:
    image: example.org/tug/driver:2.1
    volumes: [./config/tug_7.yaml:/config/robot.yaml]
    command: ros2 launch driver driver.launch.py config:=/ws/robot.yaml
```

## Good
```yaml
services:
  driver:
    image: example.org/tug/driver:2.1
    volumes: [./config/tug_7.yaml:/ws/robot.yaml]
    command: ros2 launch driver driver.launch.py config:=/ws/robot.yaml
```

## When to ignore it
When the image has a file of its own there, and reads the mounted one by itself.

## References
- https://docs.docker.com/reference/compose-file/services/#volumes
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import docker
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", symptoms=["FileNotFoundError: [Errno 2] No such file or directory: '/"])
def mount_elsewhere(robot: Robot) -> Iterator[Finding]:
    for each in docker.misplaced_mounts(robot.files, robot.runners.in_containers):
        yield finding(
            each.named,
            f"'{each.service.name}' has this file at {each.target}: nothing brings it to {each.named}",
            advice=f"mount it at {each.named}, or name {each.target}",
            related=[note(each.target, "mounted here")],
        )
