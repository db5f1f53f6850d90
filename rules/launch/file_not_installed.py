"""A file in the package's share folder is used but never installed.

## What it finds
Launch, parameter, URDF and other files of a workspace package that a launch file references through the package's
share folder or relative to itself. They exist in the source, but no `data_files` entry or `install()` rule covers
them. One finding for each folder of a package. Also launch files that the package does not install (a warning).

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
    yield from _launch_files(robot, set(missing))


def _launch_files(robot: Robot, said: set[tuple[str, str]]) -> Iterator[Finding]:
    """Launch files that are not installed, so that ``ros2 launch PACKAGE`` does not find them."""
    for package in robot.launch.workspace.packages.values():
        if not package.installs_known or not package.builds or not package.builds[0].source.judged:
            continue
        own = [file.source for file in robot.launch.files_of(package) if _is_started(file.source.name)]
        lost = [source for source in own if not package.takes(source.absolute)]
        if not lost or robot.launch.workspace.is_vendored(own[0]):
            continue
        judged = [source for source in lost if source.judged and robot.purpose(source).value == "robot"]
        judged = [source for source in judged if (package.name, _folder(package, source)) not in said]
        if judged and not _is_launched_by_path(robot, judged):
            yield _lost(package, judged, len(lost) == len(own))


def _folder(package: Package, source: Source) -> str:
    return os.path.relpath(os.path.dirname(source.absolute), package.folder)


def _lost(package: Package, lost: list[Source], every: bool) -> Finding:
    build = package.builds[0].source.basename
    more = f" and {len(lost) - 1} other{'s' if len(lost) > 2 else ''}" if len(lost) > 1 else ""
    verb, them = ("are", "them") if more else ("is", "it")
    if every:
        message = f"No launch file of {package.name} is installed: ros2 launch {package.name} finds none of them"
    else:
        message = f"{lost[0].basename}{more} of {package.name} {verb} not installed: ros2 launch does not find {them}"
    return finding(
        lost[0],
        message,
        advice=f"install the folder '{_folder(package, lost[0])}' in {build}" if every else f"install it in {build}",
        related=[
            _installation(package, lost[0].absolute),
            *([] if every else [note(each, "this one is not installed either") for each in lost[1:10]]),
        ],
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
        reference.where,
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
