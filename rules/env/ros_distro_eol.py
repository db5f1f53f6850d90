"""The robot runs a ROS distribution that no longer gets updates.

## What it finds
The distribution that the tree names (`/opt/ros/X`, `ROS_DISTRO`, the image tag `ros:X`, packages `ros-X-...`), when
it is the only one and its end of life is before today, or before the day given with `--now`. It is info where an
image to work in, or a script that looks at a running robot, is the first to name it, and where a file gives a
supported one to rosdep or Ansible (`rosdistro: jazzy`): the robot has moved on, and this is left over.

## Why it matters on a robot
Security holes stay open, and the package server removes the distribution: a robot that must be installed again
cannot be.

## Bad
```dockerfile
FROM ros:foxy
```

## Good
```dockerfile
FROM ros:jazzy
```

## When to ignore it
When you get security updates from a vendor with extended support, or the robot has no network.

## References
- REP 2000
"""

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import docker
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import distro_end
from bringup_lint.api.ros import distros_since

LOOKING = regex(r"\bros2 +(?:topic|node|param|service|action|interface|doctor|lifecycle)\b")
RUNNING = regex(r"\bros2 +(?:run|launch)\b|\bcolcon\b|\bapt(?:-get)? ")
GIVEN = regex(
    rf"(?<![A-Za-z0-9])ros_?distro[=: ][ \t]*[\"']?(?P<name>{'|'.join(distros_since('foxy'))})\b",
    re.I,
    "rosdistro ros_distro",
)
"""A distribution that is given by its name alone."""
OLDER = ("eloquent", "dashing", "crystal")


@rule("warning", tags=["CWE-1104"], symptoms=['Skip end-of-life distro "*"'])
def ros_distro_eol(robot: Robot) -> Iterator[Finding]:
    for distro in _distros(robot):
        end = distro_end(distro)
        where = next(robot.ros.mentions(distro), None) if end is not None and end < robot.today else None
        if where is not None and not robot.ros.is_development(where):
            yield finding(
                where,
                f"ROS 2 {distro.capitalize()} has had no updates since {end}, not even security fixes",
                advice="plan the migration to a supported distribution",
                severity="info" if not _runs_robot(robot, where) or _has_moved(robot) else None,
            )
            return


def _runs_robot(robot: Robot, place: Located) -> bool:
    """Whether a file may decide what runs: not an image to work in, or a script that only looks at a running robot."""
    source = place.span.source
    if source.kind == "shell-script":
        return not LOOKING.search(source.said) or RUNNING.search(source.said) is not None
    image = next((file for file in robot.dockerfiles if file.source is source), None)
    return image is None or docker.is_deployed(robot.compose, image)


def _has_moved(robot: Robot) -> bool:
    """Whether a file of the robot names a distribution that gets updates."""
    given = {match["name"].lower() for each in robot.sources if each.judged for match in GIVEN.finditer(each.said)}
    ends = map(distro_end, given)
    return any(end is None or end >= robot.today for end in ends)


def _distros(robot: Robot) -> Iterable[str]:
    """The distribution of the tree; where it names none that is known, those before the first known one."""
    if robot.target.ros:
        return [robot.target.ros]
    return [] if robot.target.ros_named else [each for each in OLDER if any(robot.ros.mentions(each))]
