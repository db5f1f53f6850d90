"""Hardware of ros2_control that is of another simulator than the one whose plugin the descriptions load."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.tree import display_name
from bringup_lint.graph.plugins.described import descriptions
from bringup_lint.graph.plugins.described import included_from
from bringup_lint.graph.plugins.described import includes_elsewhere
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.model.xml import Element

_HARDWARE = {
    "gazebo_ros2_control/GazeboSystem": "classic",
    "gz_ros2_control/GazeboSimSystem": "new",
    "ign_ros2_control/IgnitionSystem": "new",
}
"""Hardware -> the simulator that it is for."""
_LOADERS = regex(r"^(?:lib)?(?:(?P<classic>gazebo_ros2_control)|(?:gz|ign)_ros2_control-system)(?:\.so)?$")
"""The plugin of a simulator that starts the controller manager, and loads hardware of its own kind only."""

_VARIABLE = regex(r"^\$(?:\{\s*|\(\s*arg\s+)(\w+)\s*[})]$")


class OtherSimulator(NamedTuple):
    hardware: Located
    loader: Located
    """The plugin of the simulator."""
    instead: str


class _Loaded(NamedTuple):
    kind: str
    name: Located
    condition: str
    """The value of the ``xacro:if`` around it, of a single variable its name; empty without one."""


def other_simulators(files: Files, workspace: Workspace) -> Iterator[OtherSimulator]:
    """The first hardware of each description that is of another simulator than the plugin under the same condition, or
    all of whose hardware is of another one than the plugins of its package, or where its package has none, than those
    of the descriptions that are included with it."""
    hardware: dict[Source, list[_Loaded]] = {}
    loaders: dict[str, list[_Loaded]] = {}
    for source in files.of_kind("urdf"):
        root = parse(source).root if "ros2_control" in source.text and not source.template else None
        elements = root.walk() if root is not None else iter(())
        for element in elements:
            if element.local != "plugin":
                continue
            name, text = element.get("filename"), str(element.text).strip()
            match = _LOADERS.match(name.rpartition("/")[2]) if name is not None else None
            if name is not None and match is not None:
                found = _Loaded("classic" if match["classic"] else "new", name, _condition(element))
                loaders.setdefault(_folder(workspace, source), []).append(found)
            elif text in _HARDWARE:
                found = _Loaded(_HARDWARE[text], element.text.strip_located(), _condition(element))
                hardware.setdefault(source, []).append(found)
    is_apart = any(_folder(workspace, source) not in loaders for source in hardware)
    every = [each for found in loaders.values() for each in found] if is_apart else []
    robots = list(_robots(files, workspace, every))
    for source, named in hardware.items():
        own = loaders.get(_folder(workspace, source), [])
        beside = (found for names, found in robots if source.name in names)
        other = _other(named, own) or _all_other(named, own or next(beside, []))
        if source.judged and other is not None:
            yield other


def _robots(files: Files, workspace: Workspace, every: list[_Loaded]) -> Iterator[tuple[set[str], list[_Loaded]]]:
    """The robots with plugins of which the tree holds the whole description: its files, and the plugins in them."""
    if not every:
        return
    for root in descriptions(files.tree):
        paths = included_from(files.tree, [root])
        names = {display_name(path) for path in paths}
        found = [each for each in every if each.name.span.source.name in names]
        if found and not includes_elsewhere(files.tree, workspace.packages, paths):
            yield names, found


def _condition(element: Element) -> str:
    outer = next((each for each in element.ancestors if each.name == "xacro:if"), None)
    return _VARIABLE.sub(r"\1", str(outer.get("value"))) if outer is not None else ""


def _other(named: list[_Loaded], own: list[_Loaded]) -> OtherSimulator | None:
    """Hardware and plugin under one condition that do not agree."""
    for each in named:
        same = [loader for loader in own if loader.condition == each.condition] if each.condition else []
        if same and all(loader.kind != each.kind for loader in same):
            return _mismatch(each, same[0])
    return None


def _all_other(named: list[_Loaded], near: list[_Loaded]) -> OtherSimulator | None:
    if not near or {loader.kind for loader in near} & {each.kind for each in named}:
        return None
    return _mismatch(named[0], near[0])


def _mismatch(each: _Loaded, loader: _Loaded) -> OtherSimulator:
    is_old = loader.name.rpartition("/")[2].removeprefix("lib").startswith("ign")
    instead = next(name for name, kind in _HARDWARE.items() if kind == loader.kind)
    return OtherSimulator(each.name, loader.name, "ign_ros2_control/IgnitionSystem" if is_old else instead)


def _folder(workspace: Workspace, source: Source) -> str:
    owner = workspace.owner(source)
    return owner.folder if owner is not None else ""
