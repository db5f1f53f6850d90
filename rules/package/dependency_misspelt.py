"""A package.xml depends on a package that nobody has, one letter away from one that is there.

## What it finds
Dependencies that are no package of the tree and no public one that is known, that only one package.xml names, and from
which exactly one package of the tree, one common package, or one dependency of several other packages differs by a
letter. What rosdep is known not to have is reported by `package/rosdep-key-unknown`.

## Why it matters on a robot
`rosdep install` ends with "Cannot locate rosdep definition" and installs nothing. colcon does not know that the package
needs the other one: it builds it too early, and without it on its paths.

## Bad
```xml
<exec_depend>rover_controler</exec_depend>   <!-- the package of the tree is rover_controller -->
```

## Good
```xml
<exec_depend>rover_controller</exec_depend>
```

## When to ignore it
When another workspace has a package of this name.

## References
- REP 149, "Dependency tags"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.ros import instead_of


@rule("error", confidence="medium", fix="unsafe", symptoms=["Cannot locate rosdep definition for"])
def dependency_misspelt(robot: Robot) -> Iterator[Finding]:
    for each in robot.dependencies.misspelt_dependencies:
        if instead_of(each.name) is None:
            yield finding(
                each.name,
                f"There is no package {each.name}: rosdep install ends with "
                f'"Cannot locate rosdep definition for [{each.name}]"',
                advice=f"did you mean {each.meant}?",
                related=[note(each.place, f"{each.meant} is named here")] if each.place is not None else [],
                fix=fix(f"write {each.meant}", (each.name, each.meant), safe=False),
            )
