"""A variable of an image begins with a tilde that nothing expands.

## What it finds
`ENV NAME=~/...`. Docker puts in variables, and leaves the tilde as it is. Variables of which the program that reads
them expands the tilde itself, such as `ROS_HOME`, `ROS_LOG_DIR` and `TORCH_HOME`, are left out.

## Why it matters on a robot
The shell does not expand a tilde that comes out of a variable either: programs look for a folder that is called `~`,
and `mkdir -p "$NAME"` makes one. Configuration is not found, and data lands in the layer of the container.

## Bad
```dockerfile
ENV ROBOT_WS=~/ws
```

## Good
```dockerfile
ENV ROBOT_WS=/home/robot/ws
```

## When to ignore it
When the program that reads the variable expands it.

## References
- https://docs.docker.com/reference/dockerfile/#environment-replacement
- bash(1), "Tilde Expansion"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.docker import assignments

EXPANDED = ("ROS_HOME", "ROS_LOG_DIR", "TORCH_HOME", "HF_HOME", "KERAS_HOME", "PIP_CACHE_DIR")
"""rcl_logging_interface, launch, PyTorch, huggingface_hub, Keras and pip expand the tilde of these."""


@rule("warning", silent="the folder is called ~")
def env_tilde(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        for stage in file.stages:
            for instruction in stage.all("ENV"):
                for name, value in assignments(instruction):
                    if value.startswith("~/") and name not in EXPANDED:
                        yield finding(
                            value.part(0, 1),
                            f"Nothing expands the tilde: {name} begins with a folder that is called '~'",
                            advice="write the path of the home in full",
                        )
