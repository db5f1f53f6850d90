"""A file in the package's share folder is used but never installed.

## What it finds
Launch, parameter, URDF and other files of a workspace package that a launch file references through the package's
share folder or relative to itself. They exist in the source, but no `data_files` entry or `install()` rule covers
them. One finding for each folder of a package. Also packages that have launch files and install none of them.

## Why it matters on a robot
The launch file works in a workspace that is built with `--symlink-install`, and fails on the robot, where only the
installed tree exists.

## Bad
```cmake
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
```

## Good
```cmake
install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})
```

## When to ignore it
When the robot runs from a source workspace, or when a packaging step outside of setup.py and CMakeLists.txt copies
the file.

## References
- https://github.com/RobotecAI/ROSCon2023Demo/issues/116
- https://github.com/ros2/ros2_documentation/issues/2920
"""

import os
import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import Package
from bringup_lint.api.launch import Reference

Missing = tuple[Reference, Package, str]
"""A use of a file, the package that does not install it, and its path in the package."""
STARTED = (".launch.py", "_launch.py", ".launch.xml", "_launch.xml", ".launch.yaml", ".launch.yml")
"""How the names of launch files end."""


@rule(
    "error", symptoms=["FileNotFoundError", "Parameter file path is not a file", "No such file or directory: '*/share/"]
)
def file_not_installed(robot: Robot) -> Iterator[Finding]:
    missing: dict[tuple[str, str], list[Missing]] = {}
    for file in robot.launch.judged:
        for reference in {each.span: each for each in robot.launch.references(file)}.values():
            found = reference.found
            package = found.package
            if package is None or found.file is None or found.installed is not False:
                continue
            if not robot.tree.is_file(found.file):
                continue
            path = os.path.relpath(found.file, package.folder)
            missing.setdefault((package.name, os.path.dirname(path) or path), []).append((reference, package, path))
    for first, *others in missing.values():
        yield not_installed(robot, first, others)
    yield from _without_launch_files(robot, {package for package, _ in missing})


def _without_launch_files(robot: Robot, said: set[str]) -> Iterator[Finding]:
    """Packages none of whose launch files is installed, so that ``ros2 launch PACKAGE`` finds nothing."""
    for package in robot.launch.workspace.packages.values():
        if package.name in said or not package.installs_known or not package.builds:
            continue
        own = [file.source for file in robot.launch.files_of(package) if _is_started(file.source.name)]
        if not own or robot.launch.workspace.is_vendored(own[0]):
            continue
        if any(package.takes(source.absolute) for source in own):
            continue
        build = package.builds[0].source
        judged = [source for source in own if source.judged and robot.purpose(source).value == "robot"]
        if judged and build.judged and not _is_launched_by_path(robot, judged):
            folder = os.path.relpath(os.path.dirname(judged[0].absolute), package.folder)
            yield finding(
                judged[0],
                f"No launch file of {package.name} is installed: ros2 launch {package.name} finds none of them",
                advice=f"install the folder '{folder}' in {build.basename}",
                related=[_installation(package, judged[0].absolute)],
                severity="warning",
            )


def _is_started(path: str) -> bool:
    """Whether a file is a launch file by its name and folder; others may be code that builds one."""
    return path.endswith(STARTED) and "launch" in path.split("/")[:-1]


def _is_launched_by_path(robot: Robot, sources: list[Source]) -> bool:
    """Whether something of the tree launches one of the files by its path, as it lies in the source."""
    names = "|".join(re.escape(source.basename) for source in sources)
    return robot.files.mentions(re.compile(rf"\blaunch\s+(?:[^\s'\"]*/)?(?:{names})"))


def not_installed(robot: Robot, first: Missing, others: list[Missing]) -> Finding:
    """One finding for a folder without an install rule, with the other places that use it."""
    reference, package, path = first
    span = reference.span
    used = {(each.span.source.name, each.span.start): (each, file) for each, _, file in reversed(others)}
    used.pop((span.source.name, span.start), None)
    either = [note(each.span, f"{os.path.basename(file)} is not installed either") for each, file in used.values()]
    return finding(
        span,
        f"{path} of {package.name} is not installed: it exists in the source and is missing on the robot",
        advice=_advice(package, path),
        chain=robot.provenance.chain_to(span, f"{path} is opened"),
        related=[_installation(package, os.path.join(package.folder, path)), *reversed(either)],
    )


def _advice(package: Package, path: str) -> str:
    build = package.builds[0].source.basename
    if "/" in path:
        return f"install the folder '{path.partition('/')[0]}' in {build}"
    return f"install it in {build}"


def _installation(package: Package, path: str) -> Related:
    """The pattern that misses a file of its folder, the folders that are installed, or the description of the build."""
    beside = package.taking_others(path)
    if beside is None or os.path.basename(beside.source) == "package.xml":
        folders = (each for build in package.builds for each in build.installs if each.tree)
        folder = next(folders, None)
        where = folder.where if folder is not None else package.builds[0].source
        return note(where, "what the package installs")
    return note(beside.where, f"this does not match {os.path.basename(path)}")
