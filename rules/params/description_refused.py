"""A robot description that robot_state_publisher refuses.

## What it finds
In `.urdf` and `.xacro` files: joints of type `revolute` or `prismatic` without `<limit>`, limits of any joint without
`effort` or `velocity`, a lower limit above the upper one, and limits of revolute joints and `rpy` of any origin in
degrees (a warning); `xyz`, `rpy` and `size` that are not three numbers with blanks between them; and in a file or macro
two links or joints of the same name, and links that are the child of two joints (a warning). In `.urdf` files without
xacro that no other description includes also: joints whose parent or child link does not exist, and a second link
without a parent. In files for xacro: joints outside of macros whose parent or child link no description of the tree
has, when all that they include is in the tree; and included files that do not exist, outside of macros and conditions.
A file that no launch file and no other description names is reported as info, but for an include whose name is that of
another description with one letter more or less.

## Why it matters on a robot
urdfdom takes a description as a whole or not at all. robot_state_publisher ends at its start, the controller manager
and MoveIt get no robot, and no frame of it exists. With reversed limits the file is read, and every goal is out of
range. A link has one parent: what a second joint was to place is not placed. An origin in degrees is read as well, as
many turns that end anywhere: what the sensor sees is in another place.

## Bad
```xml
<joint name="mast_joint" type="prismatic">
  <parent link="base_link"/>
  <child link="mast"/>
</joint>
```

## Good
```xml
<joint name="mast_joint" type="prismatic">
  <parent link="base_link"/>
  <child link="mast"/>
  <limit lower="0" upper="1.2" effort="900" velocity="0.2"/>
</joint>
```

## When to ignore it
When the file is only a part, which a script completes.

## References
- urdfdom, urdf_parser/src/joint.cpp and model.cpp
- https://wiki.ros.org/urdf/XML/joint
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import Refused


@rule(
    "error",
    symptoms=[
        "is of type REVOLUTE but it does not specify limits",
        "joint limit: no effort",
        "Failed to build tree: parent link [*] of joint [*] not found",
        "Failed to find root link: Two root links found",
        "Unable to initialize urdf::model from robot description",
    ],
)
def description_refused(robot: Robot) -> Iterator[Finding]:
    for first, *others in robot.plugins.refused_descriptions:
        yield finding(
            first.where,
            f"{_what(first)}: {_consequence(first)}",
            advice=_advice(first),
            related=[
                *([note(first.other, "the other one")] if first.other is not None else []),
                *([note(first.lost, "a second root, which no joint names")] if first.lost is not None else []),
                *(note(each.where, _what(each)) for each in others[:10]),
            ],
            severity=_severity(first),
        )


def _severity(refused: Refused) -> str:
    """Info for a file that nothing loads."""
    if not refused.used:
        return "info"
    return "warning" if refused.what in ("limits", "degrees", "turned", "parents") else "error"


def _what(refused: Refused) -> str:
    match refused.what:
        case "no-limit":
            return f"The {refused.detail} joint '{refused.name}' has no <limit>"
        case "no-attribute":
            return f"The limit of joint '{refused.name}' has no {refused.detail}"
        case "limits":
            return f"The lower limit of joint '{refused.name}' is above the upper one ({refused.detail})"
        case "degrees":
            return f"The limits of joint '{refused.name}' are {refused.detail} radians"
        case "turned":
            whose = f"of '{refused.name}'" if refused.name else "of a shape"
            return f"The origin {whose} is turned by {refused.detail} radians"
        case "no-file":
            return f"xacro does not find the file '{refused.name}'"
        case "no-link":
            return f"Joint '{refused.detail}' names the link '{refused.name}', which does not exist"
        case "vector":
            return f"The {refused.name} is not three numbers ('{refused.detail}')"
        case "parents":
            return f"The link '{refused.name}' is the child of two joints ({refused.detail})"
        case "orphan":
            return (
                f"The link '{refused.name}' is the child of two joints ({refused.detail}), and '{refused.lost}' of none"
            )
        case "twice":
            return f"There are two {refused.detail}s called '{refused.name}'"
    return f"'{refused.name}' is a second link without a parent, beside '{refused.detail}'"


def _consequence(refused: Refused) -> str:
    if refused.what == "limits":
        return "every goal is out of range"
    if refused.what == "no-file":
        return "it makes no description, and robot_state_publisher does not start"
    if refused.what == "degrees":
        return "many turns, which nothing keeps the joint from"
    if refused.what == "parents":
        return "only one of them places it, and the link that the other one was for has no place"
    if refused.what == "turned":
        return "many turns, so that it does not point where it should"
    return "robot_state_publisher refuses the whole description"


def _advice(refused: Refused) -> str:
    match refused.what:
        case "no-limit":
            return 'add <limit lower="" upper="" effort="" velocity=""/> with the values of the axis'
        case "no-attribute":
            return f"add {refused.detail}"
        case "limits":
            return "swap them"
        case "degrees" | "turned":
            return "convert them from degrees, for example ${radians(90)}"
        case "no-file":
            return f"write {refused.detail}" if refused.detail else "add the file, or correct the path"
        case "no-link":
            return "add the link, or correct the name"
        case "vector":
            return "write three numbers with blanks between them, such as 0 0 0"
        case "parents" | "orphan":
            return "give one of the joints its own child"
        case "twice":
            return "rename one of them"
    return "join it to the others"
