"""Plugins of Gazebo Classic that robot descriptions name, and that only ROS 1 has."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.facts import table
from bringup_lint.graph.plugins.xacro_includes import is_unconditional
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.source import Source

_NAMED = regex(r"\blibgazebo_ros_\w+\.so\b", hints="libgazebo_ros_")
_CLASSIC = regex(r"[\"'( ]gazebo_ros[\"')/ ]|\bgzserver\b", hints="gazebo_ros gzserver")
_NEW = regex(r"\b(?:ros_gz|ros_ign|gz_sim|ign_gazebo)", hints="ros_gz ros_ign gz_sim ign_gazebo")
"""What starts its successor, which has plugins of its own."""
_PARTS = regex(r"\.gazebo$")
_FILE = regex(r"(?<![\w.-])[\w.-]+\.(?:urdf|xacro|gazebo)\b")


class GonePlugin(NamedTuple):
    name: Located
    instead: str


def gone_simulator_plugins(files: Files, workspace: Workspace) -> Iterator[GonePlugin]:
    """The plugins in descriptions that launch files load, themselves or as parts of others, where Gazebo Classic is
    started."""
    launched = [source for source in files.of_kind(*LAUNCH) if source.judged]
    classic = {_folder(workspace, source) for source in launched if source.matches(_CLASSIC)}
    if not classic:
        return
    launched = [each for each in launched if _folder(workspace, each) in classic or not each.matches(_NEW)]
    sources = [source for source in files.of_kind("urdf") if source.judged]
    parts = (files.tree.at(path) for path in files.tree.like(_PARTS))
    sources += [part for part in parts if part is not None]
    if not any(source.matches(_NAMED) for source in sources):
        return
    instead = {row["plugin"]: row["instead"] for row in table("ros/gazebo_plugins")}
    for source in _loaded(workspace, launched, sources):
        root = parse(source).root if source.matches(_NAMED) and _is_of_ros2(workspace, source) else None
        if root is None:
            continue
        for element in root.walk():
            name = element.get("filename") if element.local == "plugin" else None
            if name is not None and name in instead and is_unconditional(element):
                yield GonePlugin(name, instead[name])


def _folder(workspace: Workspace, source: Source) -> str:
    """The folder of the package that a file is in, else the one above its own."""
    owner = workspace.owner(source)
    return owner.folder if owner is not None else os.path.dirname(os.path.dirname(source.absolute))


def _loaded(workspace: Workspace, launched: list[Source], descriptions: list[Source]) -> Iterator[Source]:
    """The descriptions that launch files name, and those that these include: of several of one name, the ones of the
    package itself."""
    by_name: dict[str, list[Source]] = {}
    for each in descriptions:
        by_name.setdefault(each.basename, []).append(each)
    seen: set[Source] = set()
    todo = list(launched)
    while todo:
        file = todo.pop()
        folder = _folder(workspace, file)
        for name in {match[0] for match in _FILE.finditer(file.text)}:
            found = by_name.get(name, [])
            near = found if len(found) == 1 else [each for each in found if _folder(workspace, each) == folder]
            new = [each for each in near if each not in seen]
            seen.update(new)
            todo += new
    return (each for each in descriptions if each in seen)


def _is_of_ros2(workspace: Workspace, source: Source) -> bool:
    owner = workspace.owner(source)
    return not workspace.is_vendored(source) and (owner is None or "catkin" not in owner.manifest.source.text)
