"""The image removes a shell that it still needs.

## What it finds
A RUN that removes /bin/sh, /bin/bash or /bin/dash in a stage where something still needs the shell: the
`/ros_entrypoint.sh` of the ROS images, a CMD or ENTRYPOINT in shell form, or apt and dpkg after the removal.

## Why it matters on a robot
`/ros_entrypoint.sh` is a bash script, so the container does not start (`exec /ros_entrypoint.sh: no such file or
directory`). The maintainer scripts of packages also need a shell, so an apt command after the removal fails in the
build.

## Bad
```dockerfile
FROM ros:humble-ros-core
RUN rm -f /bin/sh /bin/bash /bin/dash && apt-get purge -y apt
```

## Good
```dockerfile
FROM ros:humble-ros-core
USER robot
```

## When to ignore it
When a later stage, or the deployment, replaces the entrypoint with a binary.

## References
- robotics-security guide, container hardening
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of

SHELLS = frozenset(f"{folder}/{shell}" for folder in ("/bin", "/usr/bin") for shell in ("sh", "bash", "dash"))
PACKAGE_TOOLS = frozenset(("apt", "apt-get", "dpkg"))
PLACERS = frozenset(("ln", "cp", "mv", "install"))


@rule("error", symptoms=["exec /ros_entrypoint.sh: no such file or directory"])
def rm_shell_entrypoint(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        for stage in file.stages:
            removed: dict[str, Located] = {}
            for command in commands_of(stage):
                if command.name == "rm":
                    removed |= {word.rpartition("/")[2]: word for word in command.words if word in SHELLS}
                elif command.name in PLACERS and command.words[-1] in SHELLS:
                    removed.pop(command.words[-1].rpartition("/")[2], None)
                elif command.name in PACKAGE_TOOLS and (sh := removed.get("sh", removed.get("dash"))):
                    yield finding(
                        sh,
                        f"{sh} is removed, but the {command.name} after it needs it: the build fails",
                        advice="keep the shell, or remove it last",
                        related=[note(command.words[0], "this runs the scripts of packages")],
                    )
                    break
            for shell, what, place in _users(stage):
                if shell in removed:
                    yield finding(
                        removed[shell],
                        f"{removed[shell]} is removed, but {what} needs it: the container does not start",
                        advice="keep it, or start a binary with a fixed environment",
                        related=[note(place, "this starts the container")],
                    )
                    break


def _users(stage: Stage) -> Iterator[tuple[str, str, Located]]:
    """What starts the container through a shell: the shell, a word for it, and where that is said."""
    entrypoint, command = stage.last("ENTRYPOINT"), stage.last("CMD")
    if entrypoint is None and re.match(r"(?:osrf/)?ros:", stage.origin):
        yield "bash", "/ros_entrypoint.sh of the base image", stage.image
    for instruction in filter(None, (entrypoint, command)):
        words = instruction.exec_form
        if words is None:
            yield from ((shell, f"{instruction.name} in shell form", instruction.value) for shell in ("sh", "dash"))
        elif words and words[0] == "/ros_entrypoint.sh":
            yield "bash", words[0], instruction.value
        elif words and words[0].rpartition("/")[2] in ("sh", "bash"):
            yield words[0].rpartition("/")[2], words[0], instruction.value
