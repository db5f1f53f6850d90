"""A robot description is not well-formed XML.

## What it finds
In `.urdf` and `.xacro` files, also in those that others include: end tags that do not match, elements and comments that
nothing ends, an attribute twice or without quotes. In `.xacro` files also all else that XML does not allow: prefixes
that nothing declares, `--` in a comment, a bare `&` or `<`, and text outside of the root. A file that no launch file
and no other description names is a warning.

## Why it matters on a robot
xacro and urdfdom read a description as a whole. At the first error xacro ends without an output, launch stops with what
it printed, and nothing of the launch file starts; robot_state_publisher ends at its start, and no frame of the robot
exists.

## Bad
```xml
<link name="mast">
  <visul><geometry><box size="1 1 1"/></geometry></visual>
</link>
```

## Good
```xml
<link name="mast">
  <visual><geometry><box size="1 1 1"/></geometry></visual>
</link>
```

## When to ignore it
When the file is a template that a script fills in.

## References
- https://docs.python.org/3/library/pyexpat.html, which xacro reads with
- urdfdom, urdf_parser/src/model.cpp, which reads with TinyXML-2
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "XML parsing error: mismatched tag",
        "XML parsing error: not well-formed (invalid token)",
        "Unable to initialize urdf::model from robot description",
    ],
)
def description_not_wellformed(robot: Robot) -> Iterator[Finding]:
    for problem, by, used in robot.plugins.unread_descriptions:
        words = problem.code.replace("-", " ")
        what = f"{words}, {problem.detail}" if problem.detail else words
        ends = "launch stops" if by == "xacro" else "robot_state_publisher ends at its start"
        yield finding(
            problem.where,
            f"{by} cannot read the description ({what}): {ends}",
            advice="correct the XML",
            severity=None if used else "warning",
        )
