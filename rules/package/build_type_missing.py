"""A package of ROS 2 does not export a build type that colcon knows.

## What it finds
A package.xml that exports no `build_type`, in a package that colcon builds and that is one of ament: it names a build
tool of ament, or it names none and has a setup.py that registers it in the ament index. A package inside another one is
left alone: colcon does not look for it. Also a tag in `<export>` that is nearly `build_type`, and a build type that is
nearly one that colcon knows.

## Why it matters on a robot
colcon takes such a package for one of catkin. With a CMakeLists.txt it builds and installs it, and its setup files do
not put it on AMENT_PREFIX_PATH: `ros2 run` and launch files end with "Package not found", and plugins of it are not
found. Without a CMakeLists.txt the build fails. Of a type that it does not know, colcon says "No task extension to
'build' a 'ros.ament_cmke' package", and the package is not built.

## Bad
```xml
<buildtool_depend>ament_cmake</buildtool_depend>
```

## Good
```xml
<buildtool_depend>ament_cmake</buildtool_depend>
<export>
  <build_type>ament_cmake</build_type>
</export>
```

## When to ignore it
When nothing builds the package with colcon.

## References
- REP 149, "build_type"
- catkin_pkg, `get_build_type`: catkin without an export (tried)
- colcon-ros, task/catkin/build.py: no hook for AMENT_PREFIX_PATH
"""

import os
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.launch import Package
from bringup_lint.api.packages import Manifest
from bringup_lint.api.spelling import nearest

TYPES = ("ament_cmake", "ament_python", "cmake", "catkin")
KNOWN = (*TYPES, "ament_cargo", "ament_gradle", "gradle", "python")
"""With those of extensions of colcon."""


@rule(
    "warning",
    symptoms=["Package '*' not found", "PackageNotFoundError", "No task extension to 'build' a 'ros.*' package"],
)
def build_type_missing(robot: Robot) -> Iterator[Finding]:
    packages = robot.launch.workspace.packages
    for manifest in robot.dependencies.manifests:
        yield from _misspelt(manifest)
    for package in packages.values():
        if (
            _is_guessed(robot, package)
            and robot.dependencies.judged(package)
            and not _is_inside(package, packages.values())
        ):
            built = robot.tree.exists(os.path.join(package.folder, "CMakeLists.txt"))
            end = "ros2 run and launch files do not find it" if built else "the build fails"
            yield finding(
                package.manifest.export or package.place,
                f"{package.name} exports no build type: colcon takes it for a package of catkin, and {end}",
                advice=f"add <build_type>{'ament_cmake' if built else 'ament_python'}</build_type> in <export>",
            )


def _misspelt(manifest: Manifest) -> Iterator[Finding]:
    tag, written = manifest.near_build_type, manifest.exported_type
    name = manifest.name or "the package"
    if tag is not None:
        yield finding(
            tag,
            f"colcon does not know <{tag}>: {name} exports no build type, and colcon takes it for a package of catkin",
            advice="write build_type",
        )
    near = nearest(written, TYPES) if written is not None and written not in KNOWN else []
    if written is not None and near:
        yield finding(
            written,
            f"colcon knows no build type {written}: it does not build {name}",
            advice=f"write {near[0]}",
            severity="error",
        )


def _is_guessed(robot: Robot, package: Package) -> bool:
    """Whether only the build tool, or setup.py, says that a package is one of ament."""
    manifest = package.manifest
    tools = [str(name) for tag, name in manifest.depends if tag == "buildtool_depend"]
    is_ament = any(tool.startswith("ament_") for tool in tools) if tools else _is_registered(robot, package)
    known = manifest.exported_type is not None or manifest.near_build_type is not None
    return not known and not manifest.for_both and "catkin" not in tools and is_ament


def _is_registered(robot: Robot, package: Package) -> bool:
    """Whether setup.py puts a package into the ament index."""
    setup = robot.tree.at(os.path.join(package.folder, "setup.py"))
    return setup is not None and "ament_index/resource_index" in setup.text


def _is_inside(package: Package, packages: Iterable[Package]) -> bool:
    return any(package.folder.startswith(f"{other.folder}/") for other in packages)
