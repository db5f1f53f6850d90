"""A package does not generate the interfaces that it defines.

## What it finds
Packages with files in `msg`, `srv` or `action` that speak of their generation, in package.xml or CMakeLists.txt, and
never call `rosidl_generate_interfaces`. Packages that call it without
`<member_of_group>rosidl_interface_packages</member_of_group>` in package.xml, or without the packages whose types
their interfaces have fields of in `DEPENDENCIES`, where nothing that is listed there brings them, or with a file that
does not exist. Definitions that the call does not name, and whose header a node of the tree includes, or
which a field of one that it names has as its type.

## Why it matters on a robot
Without the call, no header and no Python module is made: what includes or imports the interface does not build, or ends
at its start. Without the group, or without the dependencies, `colcon build` stops at the package.

## Bad
```cmake
rosidl_generate_interfaces(${PROJECT_NAME} "msg/HopperState.msg")   # it has a field std_msgs/Header
```

## Good
```cmake
rosidl_generate_interfaces(${PROJECT_NAME} "msg/HopperState.msg" DEPENDENCIES std_msgs)
```

## When to ignore it
When another package generates the files.

## References
- rosidl_cmake, rosidl_generate_interfaces.cmake
- https://docs.ros.org/en/jazzy/Tutorials/Beginner-Client-Libraries/Custom-ROS2-Interfaces.html
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.ros import Ungenerated

GROUP = "rosidl_interface_packages"
_TEXTS = {
    "group": (
        f"{{name}} generates interfaces and is no member of {GROUP}: its build stops",
        f"add <member_of_group>{GROUP}</member_of_group> to package.xml",
    ),
    "file": (
        "{name} generates {listed}, which does not exist: its build stops",
        "correct the name, or add the file",
    ),
    "unlisted": (
        "{name} does not generate {listed}, which a node includes: its build stops",
        "add {words} to rosidl_generate_interfaces",
    ),
    "field": (
        "{name} does not generate {listed}, which a field of its {user} has as its type: its build stops",
        "add {words} to rosidl_generate_interfaces",
    ),
    "dependency": (
        "The interfaces of {name} have fields of {listed}, which its DEPENDENCIES do not bring: its build stops",
        "name {words} behind DEPENDENCIES in rosidl_generate_interfaces",
    ),
    "none": (
        "{name} defines {some} and generates no interface: nothing can include or import them",
        "call rosidl_generate_interfaces with the files, or remove them",
    ),
}
"""Kind -> what happens, and what to write instead."""


@rule(
    "error",
    symptoms=["Packages installing interfaces must include", "rosidl_generate_interfaces() the passed file"],
)
def interface_not_generated(robot: Robot) -> Iterator[Finding]:
    for each in robot.dependencies.ungenerated:
        if not robot.dependencies.judged(each.package):
            continue
        message, advice = (text.format(**_said(each)) for text in _TEXTS[each.kind])
        yield finding(
            each.where,
            message,
            advice=advice,
            related=_related(each),
            severity=_severity(robot, each),
        )


def _related(each: Ungenerated) -> list[Related]:
    if each.kind == "group":
        return []
    used = [note(each.used, "used here")] if each.used is not None else []
    return [*used, note(each.package.place, f"the package {each.package.name}")]


def _severity(robot: Robot, each: Ungenerated) -> str | None:
    """Info where nothing of the tree speaks of the interfaces that are not generated: they are left over."""
    if each.kind != "none":
        return None
    package = re.escape(each.package.name)
    used = re.compile(rf"\b{package}(?:\.(?:msg|srv|action)\b|/(?:msg|srv|action)/|::(?:msg|srv|action)::)")
    sources = robot.of_kind("python-node", "cpp-node", "launch-python")
    return "warning" if any(package in source.text and used.search(source.text) for source in sources) else "info"


def _said(each: Ungenerated) -> dict[str, str]:
    more = f" and {len(each.names) - 1} more" if len(each.names) > 1 else ""
    return {
        "name": each.package.name,
        "listed": ", ".join(each.names),
        "words": " ".join(each.names),
        "user": each.used.source.basename if each.used is not None else "",
        "some": f"{next(iter(each.names), '')}{more}",
    }
