"""A package.xml names something that rosdep cannot resolve.

## What it finds
Dependencies of packages of ROS 2 that are neither rosdep keys nor packages: `ament_python`, which is a build type only,
names of pip such as `pyserial`, keys of Python 2 such as `python-serial` and, unless the robot has Ubuntu 20.04,
`python-yaml` and `python-opencv`, Debian packages of ROS (`ros-humble-cv-bridge`), packages of ROS 1, and names that
are one letter away from a common package (`geometry_msg`).
It is info when a script, an image or the documentation of the tree runs `rosdep install` so that it goes on (`-r`), and
nothing is meant, or something else installs it; when the tree names it in `--skip-keys`; when the tree names rosdep in
other words only; and when it never names rosdep, and scripts or images install with apt or pip. A Debian package of ROS
is a warning wherever nothing skips it.

## Why it matters on a robot
`rosdep install` ends with "Cannot locate rosdep definition for [ament_python]" and installs nothing at all: the robot
lacks the dependencies of all packages. With `-r` it installs the others, and the robot lacks this one.

## Bad
```xml
<buildtool_depend>ament_python</buildtool_depend>
<exec_depend>pyserial</exec_depend>
```

## Good
```xml
<exec_depend>python3-serial</exec_depend>
<export>
  <build_type>ament_python</build_type>
</export>
```

## When to ignore it
When a list of your own (`/etc/ros/rosdep/sources.list.d`) defines the key.

## References
- https://github.com/ros2/ros2_documentation/issues/508
- rosdep, "install": "-r Continue installing despite errors."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.ros import instead_of
from bringup_lint.api.ros import is_debian_package
from bringup_lint.api.ros import unresolved


@rule(
    "warning",
    fix="safe",
    symptoms=[
        "Cannot locate rosdep definition for",
        "could not have their rosdep keys resolved",
        "No definition of [python-yaml] for OS version",
    ],
)
def rosdep_key_unknown(robot: Robot) -> Iterator[Finding]:
    places: dict[str, list[Located]] = {}
    for place in robot.dependencies.unresolved():
        places.setdefault(str(place), []).append(place)
    for name, found in places.items():
        instead = instead_of(name)
        message, severity = _effect(robot, name, instead)
        yield finding(
            found[0],
            message,
            advice=f"write {instead}" if instead else "remove the line",
            related=[note(each, f"{name} is here too") for each in found[1:]],
            fix=fix(f"write {instead}", *((each, instead) for each in found))
            if instead and not any(f">{instead}<" in each.span.source.text for each in found)
            else None,
            severity=severity,
        )


def _effect(robot: Robot, name: str, instead: str | None) -> tuple[str, str | None]:
    """What rosdep does, and how severe it is."""
    known = unresolved(name)
    error = f'"{known.error}"'
    nothing = "it installs what comes before" if known.is_late else "no dependency is installed"
    stops = robot.dependencies.stops_rosdep(name)
    if stops or not robot.dependencies.uses_rosdep:
        return f"rosdep install stops with {error}: {nothing}", None if stops else "info"
    goes_on = f"rosdep install says {error} and goes on"
    if instead and robot.dependencies.rosdep_goes_on_without(name, instead):
        return f"{goes_on}: {instead} is not installed", None
    if is_debian_package(name) and not robot.dependencies.skips(name):
        return f"{goes_on} without it: it is the name of a Debian package, and of no key", None
    return f"{goes_on}, and stops without -r", "info"
