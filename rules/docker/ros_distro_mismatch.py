"""An image of one ROS distribution, and a command that names another.

## What it finds
In an image that is built on `ros:DISTRO` or `osrf/ros:DISTRO`:
- a step, `ENTRYPOINT` or `CMD`, a compose `command` or the entry script that uses `/opt/ros/OTHER`;
- `COPY --from` of a workspace that a stage of another distribution built.

Silent in images that install packages of the other distribution, or copy its folder.

## Why it matters on a robot
After an upgrade half of the files still name the old release. The file does not exist in the image: with `set -e` the
container ends at once and restarts forever, and without it no package is found. Libraries that another release built do
not load.

## Bad
```dockerfile
FROM ros:jazzy-ros-base
RUN . /opt/ros/humble/setup.sh && colcon build
```

## Good
```dockerfile
FROM ros:jazzy-ros-base
RUN . /opt/ros/$ROS_DISTRO/setup.sh && colcon build
```

## When to ignore it
When a step that is not seen here brings the other distribution.

## References
- https://hub.docker.com/_/ros
- REP 2000, releases and target platforms
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.docker import OtherDistro
from bringup_lint.api.docker import foreign_workspaces
from bringup_lint.api.docker import other_distros
from bringup_lint.api.docker import ros_distro


@rule("error", symptoms=["/opt/ros/*/setup.bash: No such file or directory"])
def ros_distro_mismatch(robot: Robot) -> Iterator[Finding]:
    found: dict[tuple[Source, str, str], list[OtherDistro]] = {}
    for other in other_distros(robot.dockerfiles, robot.runners.all):
        if robot.compose.images.is_chosen(other.stage, tag=True):
            continue
        key = (other.word.span.source, ros_distro(other.stage.origin), other.name)
        found.setdefault(key, []).append(other)
    for (_, distro, name), others in found.items():
        first, *more = dict.fromkeys(other.word for other in others)
        yield finding(
            first,
            f"The image is one of {distro}: there is no /opt/ros/{name} in it",
            advice="write /opt/ros/$ROS_DISTRO",
            related=[
                *(note(word, "here too") for word in more[:19]),
                note(others[0].stage.start.value, f"the image of {distro}"),
            ],
        )
    yield from _workspaces(robot)


def _workspaces(robot: Robot) -> Iterator[Finding]:
    for word, stage, built in foreign_workspaces(robot.dockerfiles):
        yield finding(
            word,
            f"This workspace is built on {ros_distro(built.origin)}, and the image is one of "
            f"{ros_distro(stage.origin)}: its libraries do not load",
            advice="write the same distribution in both stages",
            related=[note(built.start.value, "builds it"), note(stage.start.value, "runs it")],
        )
