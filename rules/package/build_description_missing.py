"""The build type of a package needs a file that the package does not have.

## What it finds
A package.xml that exports the build type `ament_cmake` where there is no CMakeLists.txt but a setup.py, or
`ament_python` where there is neither a setup.py nor a pyproject.toml but a CMakeLists.txt.

## Why it matters on a robot
`colcon build` takes the build type from package.xml: it runs CMake in a folder without a CMakeLists.txt, or setup.py
where there is none. The package is not built, nor are those that depend on it.

## Bad
```xml
<export><build_type>ament_cmake</build_type></export>   <!-- the package has only a setup.py -->
```

## Good
```xml
<export><build_type>ament_python</build_type></export>
```

## When to ignore it
When a step before the build writes the file.

## References
- REP 149, "build_type"
- colcon-ros, "ament_cmake", "ament_python"
"""

import os
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.launch import Package

NEEDED = {"ament_cmake": ("CMakeLists.txt",), "ament_python": ("setup.py", "pyproject.toml")}
OTHER = {"ament_cmake": "ament_python", "ament_python": "ament_cmake"}


@rule("error", symptoms=["does not appear to contain CMakeLists.txt"])
def build_description_missing(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        written = package.manifest.exported_type
        if written not in NEEDED or not robot.dependencies.judged(package) or _has(robot, package, written):
            continue
        other = OTHER[written]
        if _has(robot, package, other):
            yield finding(
                written,
                f"colcon build of {package.name} fails: {written} needs a {NEEDED[written][0]}, "
                f"and the package has a {NEEDED[other][0]}",
                advice=f"write {other}",
            )


def _has(robot: Robot, package: Package, build_type: str) -> bool:
    return any(robot.tree.exists(os.path.join(package.folder, name)) for name in NEEDED[build_type])
