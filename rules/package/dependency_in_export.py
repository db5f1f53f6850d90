"""A dependency in `<export>` of a package.xml, which nobody reads.

## What it finds
Tags such as `exec_depend` and `depend` inside `<export>`, of packages that the file does not name outside of it.

## Why it matters on a robot
What `<export>` holds is for tools that look for their own tags. `rosdep install` does not install the package, and
colcon does not build it first: a new robot misses it, and launch files end with "Package not found".

## Bad
```xml
<export>
  <exec_depend>slam_toolbox</exec_depend>
  <build_type>ament_cmake</build_type>
</export>
```

## Good
```xml
<exec_depend>slam_toolbox</exec_depend>
<export>
  <build_type>ament_cmake</build_type>
</export>
```

## When to ignore it
When a tool of the project reads the tag there.

## References
- REP 149, "Export"
- catkin_pkg 1.1, `package.py`: `parse_package_string` (tried: the dependency is in `exports` only)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["Package '*' not found", "PackageNotFoundError"])
def dependency_in_export(robot: Robot) -> Iterator[Finding]:
    for manifest in robot.dependencies.manifests:
        declared = {str(name) for _, name in manifest.depends}
        lost = [name for name in manifest.exported_depends if name and str(name) not in declared]
        for first in lost[:1]:
            yield finding(
                first,
                f"Nobody reads a dependency in <export>: rosdep does not install {first}, and colcon does not build it "
                "before this package",
                advice="move the line out of <export>",
                related=[note(name, f"{name} as well") for name in lost[1:]],
            )
