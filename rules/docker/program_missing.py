"""A container starts a script that nothing brings into its image.

## What it finds
An ENTRYPOINT, a CMD, or the `entrypoint:` or `command:` of a compose service that starts a shell or Python script by
its path, and an image of the tree on an official one in which no instruction puts that file: no COPY or ADD has its
path or a folder above it as its target, or the folder of the tree that it copies does not hold it, no step names it,
and no volume is mounted there.

Silent below `/usr`, `/opt/ros` and the folders that a build makes (`install`, `build`), for paths with variables, and
below folders that a step may fill from the network.

## Why it matters on a robot
Docker starts nothing: "exec: no such file or directory". With a restart policy the container starts again and again.

## Bad
```dockerfile
FROM ros:jazzy-ros-base
COPY src /ws/src
ENTRYPOINT ["/entrypoint.sh"]
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
COPY src /ws/src
COPY --chmod=755 docker/entrypoint.sh /entrypoint.sh
ENTRYPOINT ["/entrypoint.sh"]
```

## When to ignore it
When whoever runs the image mounts the script.

## References
- https://docs.docker.com/reference/dockerfile/#entrypoint
- https://docs.docker.com/reference/dockerfile/#copy
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.docker import missing_programs


@rule(
    "error",
    confidence="medium",
    symptoms=[
        "exec * no such file or directory",
        "OCI runtime create failed: * no such file or directory",
        "exec: *: executable file not found in $PATH",
        "exec: *: no such file or directory",
        "/*entrypoint*: line *: exec: *: not found",
        "/*entrypoint*: line *: *: No such file or directory",
    ],
)
def program_missing(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for missing in missing_programs(robot.files, robot.runners.all):
        if missing.word.span in seen:
            continue
        seen.add(missing.word.span)
        yield finding(
            missing.word,
            f"Nothing brings {missing.path} into the image: {missing.runner.name} does not start",
            advice=f"add COPY --chmod=755 {missing.found or 'FILE'} {missing.path}",
            related=[note(missing.stage.start.keyword, "this image lacks it")],
        )
