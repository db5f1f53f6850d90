"""A build installs a file or folder that does not exist.

## What it finds
`install(FILES)`, `install(PROGRAMS)` and `install(DIRECTORY)` of a CMakeLists.txt, and data_files of a setup.py, whose
file or folder is not in the tree, and modules in `packages` of a setup.py without their folder, also where
`package_dir` names another one. Not reported is what has a condition or `OPTIONAL`, what git ignores, what lies in a
submodule, what the build description names a second time, because it may make it, and models, meshes, images and the
like, which many robots fetch.

## Why it matters on a robot
`colcon build` ends with "file INSTALL cannot find" or "can't copy", and the package is not installed on a fresh robot.
git keeps no empty folders: a folder that exists on the developer's machine is missing after a clone.

## Bad
```cmake
# there is no scripts/calibrate.py
install(PROGRAMS scripts/drive.py scripts/calibrate.py DESTINATION lib/${PROJECT_NAME})
```

## Good
```cmake
install(PROGRAMS scripts/drive.py DESTINATION lib/${PROJECT_NAME})
```

## When to ignore it
When a script makes or fetches the file before the build.

## References
- cmake-commands(7), "install": OPTIONAL
- CMake 3.25: "file INSTALL cannot find ...: No such file or directory"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=["file INSTALL cannot find", "can't copy '*': doesn't exist or not a regular file"],
)
def installed_file_missing(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        missing = robot.dependencies.missing_files(package) if robot.dependencies.judged(package) else []
        if not missing:
            continue
        first, *others = missing
        kind = "folder" if first.tree else "file"
        yield finding(
            first.where,
            f"colcon build of {package.name} fails: {first.source} does not exist in a fresh checkout",
            advice=f"remove it from the installation, or add the {kind} to the repository",
            related=[note(other.where, f"{other.source} is missing too") for other in others],
        )
