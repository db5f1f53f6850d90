"""A launch file names a file that does not exist.

## What it finds
Maps, worlds, robot descriptions and configurations in the share folder of a package of the workspace, or beside the
launch file, that neither exist in the source nor are made by the build: as parameters, as arguments of programs, as
arguments of included launch files, defaults among them, and where the code of the launch file reads them itself. Files
that git ignores or a build makes are left alone, those that the launch file asks for before it uses them, and those
that a node of the tree or, by its name, a program writes. It is an info where the path is the value of an argument that
launch files only hand on and nothing reads, and where nothing else starts the launch file and each file that includes
it gives another value, or switches off what takes the path. Where a folder between is not known, the file is missing if
the whole tree has none of its name. Included launch files and parameter files have rules of their own.

## Why it matters on a robot
The program that is given the path ends, or runs without the file: map_server does not activate, RViz shows an empty
view, and xacro makes the whole launch fail.

## Bad
```python
DeclareLaunchArgument('map', default_value=os.path.join(share, 'maps', 'barn.yaml'))   # the file is maps/stable.yaml
```

## Good
```python
DeclareLaunchArgument('map', default_value=os.path.join(share, 'maps', 'stable.yaml'))
```

## When to ignore it
When the file is made on the robot, such as a map that is recorded there.

## References
- launch, `PathJoinSubstitution`
- https://docs.nav2.org/configuration/packages/configuring-map-server.html
"""

import os
import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import LaunchFile
from bringup_lint.api.launch import Package
from bringup_lint.api.launch import Reference
from bringup_lint.api.spelling import nearest

_READ = tuple(
    ".yaml .yml .rviz .urdf .xacro .srdf .sdf .world .xml .lua .json .bt .pcd .ply .stl .dae .onnx .pgm .png".split()
)
"""Files that programs read and people write."""
_WRITTEN = regex(r"(?i)save|output|out_|log|record|export|write|dump|result|calib|cache|generated|tmp")
"""Names of files that a program makes."""
_WRITES = regex(
    r"open\((?:[^()\n]|\([^()\n]{0,80}\)){1,200}[\"'][wa]b?\+?[\"']|\.write_text\(|\bdump\(|\bcopy(?:file)?\(|\bofstream\b",
    hints="open( .write_text( dump( copy( copyfile( ofstream",
)
"""A launch file or a node makes files itself."""
_ASKS = r"\b(?:exists|isfile|is_file|access)\s{0,4}\(\s{0,4}"
_ASKED = regex(
    rf"{_ASKS}(?:[\w.]{{1,40}}\(\s{{0,4}})?\Z|\b(?P<name>\w{{1,80}})\s{{0,4}}=\s{{0,4}}(?:[\w.]{{1,40}}\(\s{{0,4}})?\Z"
)
"""What is before a path: a question whether it exists, or the variable that it is given to."""
_BEFORE = 160
"""Code points before a path."""


@rule("warning", symptoms=["No such file or directory: '*/share/*'", "Failed to load map yaml file"])
def file_missing(robot: Robot) -> Iterator[Finding]:
    places: dict[str, list[tuple[Reference, Package]]] = {}
    told = {reference.span for kind in ("parameters", "include") for reference, _ in robot.launch.missing(kind)}
    missing = list(robot.launch.missing("path"))
    writers = _writers(robot) if missing else []
    for reference, package in missing:
        if _is_written_by_node(robot, reference, writers):
            continue
        if reference.span in told or package.makes_files or _is_ignored(robot, reference, package):
            continue
        if _is_read(reference):
            places.setdefault(f"{package.name}/{reference.name}", []).append((reference, package))
    for (first, package), *others in places.values():
        near = nearest(first.name, sorted(_names(robot, package)), 3)
        effect = "launch reads it and ends" if first.aborts else "what is given the path runs without it, or ends"
        is_elsewhere = first.name in near
        spans = {each.span: each for each, _ in others if each.span != first.span}
        idle = {each.span for each, _ in ((first, package), *others) if _is_idle(robot, each)}
        yield finding(
            first.where,
            f"{first.path_in(package) if is_elsewhere else first.name} does not exist in {package.name}: {effect}",
            advice=f"use {near[0]}" if near and not is_elsewhere else "correct the path, or add the file",
            related=[
                note(package.place, f"the package {package.name}"),
                *(note(each, "it is named here, too") for each in spans),
            ],
            chain=robot.provenance.chain_to(first.span, f"{first.name} is named"),
            severity="info" if first.optional or idle.issuperset((first.span, *spans)) else None,
        )


def _is_read(reference: Reference) -> bool:
    """Whether a path means a file that has to be there."""
    is_written = _WRITTEN.search(reference.name) or _WRITTEN.search(reference.key)
    if _WRITES.search(reference.span.source.text) or _is_asked_for(reference):
        return False
    return reference.name.endswith(_READ) and not is_written


def _is_idle(robot: Robot, reference: Reference) -> bool:
    return _is_unread(robot, reference) or _is_replaced(robot, reference)


def _is_unread(robot: Robot, reference: Reference) -> bool:
    """Whether a path is only the value of an argument that no launch file reads."""
    file = robot.launch.of_source(reference.span.source)
    if not reference.key or file is None:
        return False
    expansion = robot.launch.expansion(file)
    targets = [each.target for each in expansion.includes if each.source is file and reference.key in each.arguments]
    if not targets and all(each.name != reference.key for each in expansion.declared):
        return False
    return not any(_reads(robot, target or file, reference.key) for target in targets or [file])


def _is_replaced(robot: Robot, reference: Reference) -> bool:
    """Whether each file that includes the launch file gives the argument another value, or switches off what reads
    the path."""
    file = robot.launch.of_source(reference.span.source)
    leading = [] if file is None else [each for each in robot.launch.leading_to(file) if each.entry is not file]
    if file is None or not leading or _is_started_so(robot, file, reference.key):
        return False
    given = [reference.key in each.arguments for one in leading for each in one.includes if each.target is file]
    return (
        all(given)
        if any(given)
        else _is_started(robot.launch.expansion(file), file, reference.span)
        and not any(_is_started(each, file, reference.span) for each in leading)
    )


def _is_started_so(robot: Robot, file: LaunchFile, name: str) -> bool:
    """Whether a unit or a script of the tree starts the launch file itself, without the argument, or without any."""
    given = ({str(name) for name, _ in each.arguments} for each in robot.runners.launching(file))
    return any(name not in names if name else not names for names in given)


def _is_started(expansion: launch.Expansion, file: LaunchFile, span: Span) -> bool:
    """Whether a node that a place is in is started without arguments."""
    nodes = (each for each in expansion.nodes if each.file is file and each.by_default is not False)
    return any(each.span.start <= span.start < each.span.end for each in nodes)


def _reads(robot: Robot, file: LaunchFile, name: str) -> bool:
    """Whether a launch file, or one that goes with it, does more with a configuration than to hand it on."""
    expansions = (robot.launch.expansion(file), *robot.launch.leading_to(file))
    return any(launch.is_used(robot.launch, each, name) for expansion in expansions for each in expansion.files)


def _writers(robot: Robot) -> list[Source]:
    """The sources of nodes that write files."""
    return [each for each in robot.files.of_kind("python-node", "cpp-node") if _WRITES.search(each.text)]


def _is_written_by_node(robot: Robot, reference: Reference, writers: list[Source]) -> bool:
    """Whether a source that declares the parameter, or names the file, writes files."""
    name, key = os.path.basename(reference.name), reference.key
    declared = rf"|declare_parameter\b[^()]{{0,40}}\(\s{{0,40}}[\"']{re.escape(key)}[\"']" if key else ""
    known = re.compile(rf"\b{re.escape(name)}\b{declared}")
    naming = (each for each in writers if name in each.text or (key and key in each.text))
    return any(known.search(each.text) and _is_started_here(robot, reference, each) for each in naming)


def _is_started_here(robot: Robot, reference: Reference, source: Source) -> bool:
    """Whether a launch file names the package of a source."""
    owner = robot.launch.workspace.owner(source)
    return owner is not None and owner.name in reference.span.source.text


def _is_asked_for(reference: Reference) -> bool:
    """Whether the launch file looks whether the path exists, at once or by the name of its variable."""
    text = reference.span.source.text
    found = _ASKED.search(text[max(0, reference.span.start - _BEFORE) : reference.span.start])
    if found is None or found["name"] is None:
        return found is not None
    name = re.escape(found["name"])
    return re.search(rf"{_ASKS}{name}\b|\b{name}\s{{0,4}}\.\s{{0,4}}(?:exists|is_file)\(", text) is not None


def _is_ignored(robot: Robot, reference: Reference, package: Package) -> bool:
    """Whether git ignores files of this kind in any folder of the package."""
    suffix = os.path.splitext(reference.name)[1]
    folders = ("", "maps", "map", "config", "worlds", "urdf")
    paths = (os.path.join(package.folder, folder, f"{'x'}{suffix}") for folder in folders)
    return any(robot.tree.is_ignored(os.path.join(os.path.dirname(path), reference.name)) for path in paths)


def _names(robot: Robot, package: Package) -> set[str]:
    """The names of the files in a package."""
    start = f"{package.folder}{os.sep}"
    return {os.path.basename(path) for path in robot.tree.paths if os.path.abspath(path).startswith(start)}
