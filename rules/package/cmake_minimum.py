"""A CMakeLists.txt asks for a version of CMake that CMake 4 refuses.

## What it finds
`cmake_minimum_required(VERSION ...)` and `cmake_policy(VERSION ...)` of a package with a version below 3.5, and without
a range that reaches it. It is an info where the robot does not run Lyrical or Rolling, and nothing is said where a file
sets CMAKE_POLICY_VERSION_MINIMUM.

## Why it matters on a robot
CMake 4 ends with an error at the line: it does not know how CMake before 3.5 behaved. Ubuntu 26.04, for which Lyrical
and Rolling are built, has CMake 4, and so has each machine where pip or snap installed a current one.

## Bad
```cmake
cmake_minimum_required(VERSION 2.8.3)
```

## Good
```cmake
cmake_minimum_required(VERSION 3.8)
```

## When to ignore it
When the package is only built where the distribution has an older CMake.

## References
- CMake 4.0, release notes, "Deprecated and Removed Features"
- cmake_minimum_required(VERSION), "Policy version"
- REP 2000, "Lyrical Luth": Ubuntu 26.04
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

WITH_FOUR = ("lyrical", "rolling")
"""The distributions for a release of Ubuntu with CMake 4."""
RAISED = "CMAKE_POLICY_VERSION_MINIMUM"
USUAL = "3.8"
"""What ``ros2 pkg create`` writes."""


@rule("warning", symptoms=["Compatibility with CMake < 3.5 has been removed from CMake"])
def cmake_minimum(robot: Robot) -> Iterator[Finding]:
    found = [
        (package, *each)
        for package in robot.launch.workspace.packages.values()
        for each in robot.dependencies.old_minimums(package)
    ]
    if not found or any(RAISED in source.text for source in robot.sources if source.kind != "cmake"):
        return
    ros = robot.target.ros
    has_four = ros in WITH_FOUR
    where = f"CMake 4 of Ubuntu 26.04, on which {ros} runs," if has_four else "CMake 4"
    for package, command, version in found:
        yield finding(
            version,
            f"{where} refuses {command}(VERSION {version}), and {package.name} is not built",
            advice=f"write VERSION {USUAL}, which has all that distributions of ROS 2 need",
            severity=None if has_four else "info",
        )
