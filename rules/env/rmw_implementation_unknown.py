"""RMW_IMPLEMENTATION is not a known middleware.

## What it finds
A value that is neither an RMW package of ROS 2, micro-ROS or a known project, nor a package of the workspace. On
distributions before Humble also
rmw_zenoh_cpp.

## Why it matters on a robot
Every ROS process exits at start with code 102, because the library cannot be loaded.

## Bad
```sh
RMW_IMPLEMENTATION=rmw_cyclonedds
```

## Good
```sh
RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
```

## When to ignore it
When the robot has an RMW package that is not in the tree, such as one of a vendor.

## References
- https://docs.ros.org/en/rolling/Concepts/Intermediate/About-Different-Middleware-Vendors.html
- https://github.com/BerkeleyAutomation/FogROS2/issues/40
- https://index.ros.org/r/rmw_zenoh: released for Humble since 0.1.0
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.ros import RMW_IMPLEMENTATIONS
from bringup_lint.api.ros import at_least
from bringup_lint.api.spelling import nearest

OTHERS = frozenset("rmw_microxrcedds rmw_email_cpp rmw_desert rmw_iceoryx_cpp rmw_iceoryx2_cxx rmw_hazcat".split())
"""Middleware outside of the ROS distributions: micro-ROS and research."""


@rule("error", fix="unsafe", symptoms=["failed to load shared library", "Error getting RMW implementation identifier"])
def rmw_implementation_unknown(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("RMW_IMPLEMENTATION"):
        name = setting.text
        if not name or name in OTHERS or name in _own(robot):
            continue
        known = [rmw for rmw in RMW_IMPLEMENTATIONS if rmw != "rmw_zenoh_cpp" or _has_zenoh(robot)]
        if name in known:
            continue
        near = (
            [rmw for rmw in known if name.lower().replace("rmw_", "").removesuffix("_cpp") in rmw]
            if len(name) > 3
            else []
        )
        near = near[:1] or nearest(name, known)
        yield finding(
            setting.value,
            f"RMW_IMPLEMENTATION '{name}' is not a middleware"
            + (f" of {robot.target.ros}" if name in RMW_IMPLEMENTATIONS else "")
            + ": every ROS process exits at start",
            advice=f"write {near[0]}" if near else f"write one of {', '.join(known)}",
            fix=fix(f"write {near[0]}", (setting.value, near[0]), safe=False) if near else None,
        )


def _has_zenoh(robot: Robot) -> bool:
    return at_least(robot.target.ros, "humble") is not False


def _own(robot: Robot) -> set[str]:
    """Middleware packages of the workspace."""
    return {
        name
        for source in robot.of_kind("ros-package")
        if "rmw_implementation_packages" in source.said
        for name in [source.text.partition("<name>")[2].partition("</name>")[0].strip()]
    }
