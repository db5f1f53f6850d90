"""A robot description names a mesh that its package does not have.

## What it finds
`<mesh filename="package://...">` and `file://$(find ...)` in `.urdf` and `.xacro` files that lead into a package of the
tree, where the package has one whose name differs in upper and lower case only, or by one letter more or less.
Properties that the file sets once are put in. Not reported is what git ignores and what lies in a submodule.

## Why it matters on a robot
RViz and Gazebo show nothing in its place and print an error for each mesh. Where it is the collision geometry, MoveIt
plans through the part of the robot that the mesh stands for. A file system that does not tell upper from lower case, on
the machine where the description was made, hides that.

## Bad
```xml
<mesh filename="package://crane_description/meshes/Boom.STL"/>  <!-- the file is called boom.stl -->
```

## Good
```xml
<mesh filename="package://crane_description/meshes/boom.stl"/>
```

## When to ignore it
When the meshes are copied into the package after it was cloned.

## References
- https://wiki.ros.org/urdf/XML/link (mesh)
- resource_retriever, retriever.cpp
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=["Could not load resource [package://*]", "Error retrieving file [package://*]"],
)
def mesh_missing(robot: Robot) -> Iterator[Finding]:
    for first, *others in robot.plugins.missing_meshes:
        more = f", nor {len(others)} more of this description" if others else ""
        collides = any(each.collides for each in (first, *others))
        moveit = ", and MoveIt does not avoid that part of the robot" if collides else ""
        yield finding(
            first.where,
            f"{first.package} has no {first.path}{more}: RViz and Gazebo show nothing there{moveit}",
            advice=f"write {first.like}, which the package has",
            related=[note(each.where, "missing too") for each in others[:10]],
        )
