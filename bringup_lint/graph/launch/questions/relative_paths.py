"""Files that launch files name relative to the folder in which ``ros2 launch`` happens to run."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.packages import asks_for_share
from bringup_lint.graph.launch.references import base_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import children
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.model.launch import LaunchFile

_RELATIVE = regex(r"[\w.-][\w./-]*\Z")
_PARAMETERS = (".yaml", ".yml")
_LAUNCH = (".launch.py", "_launch.py", ".launch.xml", ".launch.yaml", ".launch.yml", ".launch")
_READ = (*_PARAMETERS, ".rviz", ".urdf", ".xacro", ".srdf", ".sdf", ".world", ".lua", ".json", ".pcd")
_AS_GIVEN = frozenset(("nav2_map_server", "robot_state_publisher", "rviz2"))
"""Public packages whose programs open a path as they get it; others put a folder before it."""
FOLDER = regex(
    r"^[ \t]*WorkingDirectory[ \t]*=|\bworking_dir[ \t]*:|^[ \t]*WORKDIR[ \t]"
    r"|^[ \t]*cd[ \t][^\n]{1,300}(?:\n[^\n]{0,300}){0,20}?\bros2[ \t]+launch\b",
    re.M,
)
"""What chooses the folder in which ros2 launch runs."""


class Relative(NamedTuple):
    kind: str
    """``parameters``, ``include`` or ``path``."""
    path: Located


def relative_paths(launch: Launch, files: Files, file: LaunchFile) -> Iterator[Relative]:
    """Parameter files and includes; other paths where the package or the tree has the file."""
    found: dict[int, Relative] = {}
    for each in _named(launch, files, file):
        if each.path.span.source is file.source and not _is_anchored(launch, files, file, each.path):
            found.setdefault(each.path.span.start, each)
    yield from found.values()


def _named(launch: Launch, files: Files, file: LaunchFile) -> Iterator[Relative]:
    expansion = launch.expansion(file)
    values: list[Value] = []
    for include in expansion.includes:
        if include.source is file:
            yield from _relative("include", include.file, _LAUNCH)
    for node in expansion.nodes:
        if node.file is file:
            sources = [base_of(source) for source in node.parameters]
            for source in sources:
                yield from _relative("parameters", source, _PARAMETERS)
            if _opens_as_given(launch, node):
                values += [source for source in sources if isinstance(source, DictValue)]
                values += node.arguments
    for inner in (inner for value in values for inner in _whole(value)):
        for each in _relative("path", inner, _READ):
            if "/" in each.path and _exists(files, file, each.path):
                yield each


def _opens_as_given(launch: Launch, node: Started) -> bool:
    """Whether a program takes a path as it is, and does not look for it in a package or folder of its own."""
    name = str(literal_text(node.package))
    own = launch.workspace.packages.get(name)
    return name in _AS_GIVEN if own is None else not asks_for_share(launch, own.folder)


def _whole(value: Value) -> Iterator[Value]:
    """A value, and those of a list or dictionary, without the parts that paths and texts are made of."""
    if isinstance(value, (DictValue, ListValue, Choice)):
        for inner in children(value):
            yield from _whole(inner)
    else:
        yield value


def _relative(kind: str, value: Value, ends: tuple[str, ...]) -> Iterator[Relative]:
    path = literal_text(value)
    if path is not None and path.endswith(ends) and _RELATIVE.match(path):
        yield Relative(kind, path)


def _exists(files: Files, file: LaunchFile, path: str) -> bool:
    return any(files.tree.is_file(os.path.normpath(os.path.join(folder, path))) for folder in _above(files, file))


def _is_anchored(launch: Launch, files: Files, file: LaunchFile, path: str) -> bool:
    """Whether the launch file is for its own folder and not installed; or whether the tree chooses a working
    directory, and has the file in a folder above the package."""
    package = launch.workspace.owner(file.source)
    beside = os.path.join(os.path.dirname(file.source.absolute), path)
    if package is None or files.tree.is_file(os.path.normpath(beside)):
        return True
    if package.installs_known and not package.takes(file.source.absolute):
        return True
    above = [folder for folder in _above(files, file) if len(folder) < len(package.folder)]
    found = any(files.tree.is_file(os.path.normpath(os.path.join(folder, path))) for folder in above)
    return found and files.mentions(FOLDER)


def _above(files: Files, file: LaunchFile) -> Iterator[str]:
    """The folders that hold a launch file, up to the top of the tree."""
    tops = {os.path.abspath(top) for top in files.tree.tops}
    folder = os.path.dirname(file.source.absolute)
    while folder not in tops and os.path.dirname(folder) != folder:
        yield folder
        folder = os.path.dirname(folder)
    yield folder
