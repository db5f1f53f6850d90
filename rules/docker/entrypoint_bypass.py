"""The entrypoint of the ROS image is replaced without sourcing ROS.

## What it finds
An ENTRYPOINT that starts `ros2` directly on an official ROS image, in a Dockerfile that mentions neither
`/ros_entrypoint.sh` nor a setup file.

## Why it matters on a robot
Without `/ros_entrypoint.sh` the environment is empty: `ros2: command not found`, or nodes that do not find their
libraries.

## Bad
```dockerfile
FROM ros:jazzy
ENTRYPOINT ["ros2", "launch", "base", "base.launch.py"]
```

## Good
```dockerfile
FROM ros:jazzy
ENTRYPOINT ["/ros_entrypoint.sh", "ros2", "launch", "base", "base.launch.py"]
```

## When to ignore it
When the runtime sets the complete ROS environment, for example through an env file of the compose service.

## References
- docker-library ros image, ros_entrypoint.sh
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import distros_since

OFFICIAL = regex(rf"(?:^|/)(?:osrf/)?ros:(?:{'|'.join(distros_since('humble'))})")
SOURCES = regex(r"setup\.(?:ba|z)?sh|ros_entrypoint\.sh")


@rule("info", symptoms=['exec: "ros2": executable file not found in $PATH'])
def entrypoint_bypass(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        stage = file.final
        entrypoint = stage.last("ENTRYPOINT") if stage else None
        if stage is None or entrypoint is None or not OFFICIAL.search(stage.origin) or SOURCES.search(file.source.said):
            continue
        words = entrypoint.exec_form or entrypoint.value.split()
        if words and words[0].rpartition("/")[2] == "ros2":
            yield finding(
                entrypoint.value,
                "This replaces /ros_entrypoint.sh: ROS is not sourced in the container",
                advice='put "/ros_entrypoint.sh" first',
            )
