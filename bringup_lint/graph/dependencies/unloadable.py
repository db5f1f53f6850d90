"""Plugins that pluginlib does not load, because their description and what the package builds do not agree."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.endings import CPP_HEADERS
from bringup_lint.graph.memo import kept
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cmake_commands import commands
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Package
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.model.package import Build
    from bringup_lint.model.xml import Element

_EXPORT = "pluginlib_export_plugin_description_file"
_EXPORTED = regex(
    r"^[ \t]*PLUGINLIB_EXPORT_CLASS[ \t]*\(\s{0,80}(?:::)?(?P<class>[\w:]+)\s{0,80},\s{0,80}(?:::)?[\w:<> ,]+\)",
    re.M,
    "PLUGINLIB_EXPORT_CLASS",
)
_OTHERS = regex(
    r"^[^/\n]{0,200}\b(?:PLUGINLIB_EXPORT_CLASS|CLASS_LOADER_REGISTER_CLASS|PLUGINLIB_DECLARE_CLASS)",
    re.M,
    "PLUGINLIB_EXPORT_CLASS CLASS_LOADER_REGISTER_CLASS PLUGINLIB_DECLARE_CLASS",
)
"""These, and macros that make or use the macro."""
_LOADER = regex(
    r"\bClassLoader\s{0,4}<[^;{}()\"]{1,200}>[>\s]{0,80}\w{0,80}\s{0,40}[({]\s{0,200}\"(?P<package>\w+)\"\s{0,80},"
    r"\s{0,200}\"(?P<base>[\w:<>]+)\"",
    hints="ClassLoader",
)
_LIBRARY = regex(r"^(?:.*/)?(?:lib)?([^/]+?)(?:\.so)?$")
_LOADERS = {
    **dict.fromkeys(("hardware_interface", "controller_interface", "nav2_core", "nav2_costmap_2d", "rviz_common"), ""),
    **{"image_transport": "", "dwb_core": "", "opennav_docking_core": "", "gz_ros2_control": ""},
    **{"kinematics": "moveit_core", "planning_interface": "moveit_core", "rqt_gui_cpp": "rqt_gui"},
}
"""The namespace of a public base class -> the package under whose name its plugins are looked for; empty where both are
called alike. Source: the calls of ``pluginlib::ClassLoader`` in ros2_control, navigation2, rviz, image_common, MoveIt,
rqt and gz_ros2_control, Humble to Kilted."""
_ADDS = ("ament_add_", "catkin_add_")
_BUILD = ("cmake", "ros-package")
"""Kinds that name a class without loading it."""
_DEEP = 20
"""Libraries that link each other."""


class Unloadable(NamedTuple):
    kind: str
    """``category``, ``class``, ``library`` or ``source``."""
    where: Located
    """The package that is exported for, the class, or the library."""
    written: str
    """The same in plain form."""
    name: Located
    """The class, as it is loaded."""
    meant: str
    """What would be right; empty when that is not known."""
    related: Located | None
    """What it is compared with: the loader, the class that is exported, the library that is built."""
    is_named: bool = True
    """Another file of the tree names the class, so that something may load it."""


def unloadable(files: Files, workspace: Workspace, package: Package) -> Iterator[Unloadable]:
    """The first class of each description that pluginlib cannot load."""
    if package.complete and package.manifest.build_type == "ament_cmake":
        yield from _Plugins(files, workspace, package).unloadable()


class _Plugins:
    """The plugins of one package."""

    def __init__(self, files: Files, workspace: Workspace, package: Package) -> None:
        self._files = files
        self._workspace = workspace
        self._package = package
        self._builds = [build for build in package.builds if build.source.kind == "cmake"]

    def unloadable(self) -> Iterator[Unloadable]:
        for build in self._builds:
            for command in commands(build.source):
                if command.name == _EXPORT and len(command.arguments) > 1:
                    category, path = command.arguments[:2]
                    for each in self._of_description(build, category, str(path)):
                        yield each._replace(is_named=self._is_named(each))

    def _is_named(self, found: Unloadable) -> bool:
        known = {found.name.span.source} | ({found.related.span.source} if found.related is not None else set())
        others = (each for each in self._files.sources if each.kind not in _BUILD and each not in known)
        return any(found.name in each.text for each in others)

    def _of_description(self, build: Build, category: Located, path: str) -> Iterator[Unloadable]:
        path = path.replace("${CMAKE_CURRENT_SOURCE_DIR}", ".").replace("${PROJECT_NAME}", self._package.name)
        source = self._files.tree.beside(build.source, path)
        root = parse(source).root if source is not None and not source.template else None
        if root is None:
            return
        classes = [each for each in root.walk() if each.local == "class" and each.get("base_class_type")]
        yield from self._wrong_category(category, classes)
        for element in classes:
            found = self._compared(element)
            if found is not None:
                yield found
                return

    def _wrong_category(self, category: Located, classes: list[Element]) -> Iterator[Unloadable]:
        """The package for which the plugins are exported, where none of them is looked for under its name."""
        name = self._package.name if category == "${PROJECT_NAME}" else str(category)
        bases = {str(each.get("base_class_type")) for each in classes}
        if not bases or "$" in name or any(base.partition("::")[0] == name for base in bases):
            return
        loaders = [each for base in bases for each in _loaders(self._files).get(base, ())]
        wanted = {str(each) for each in loaders} | {each for each in map(_public_loader, bases) if each}
        if wanted and name not in wanted:
            cls = classes[0].get("name") or classes[0].get("type") or category
            yield Unloadable("category", category, name, cls, min(wanted), loaders[0] if loaders else None)

    def _compared(self, element: Element) -> Unloadable | None:
        """A class of a library, compared with what the sources export and the library holds."""
        library, cls = _path_of(element), element.get("type")
        match = _LIBRARY.match(library.strip()) if library is not None else None
        if library is None or match is None or cls is None or not self._exported:
            return None
        name, made = match[1], self._targets_of(match[1])
        exported = self._exported.get(str(cls).strip().removeprefix("::"))
        if exported is None:
            return self._unexported(element, cls) if made and self._is_own(made) else None
        holders = self._holders(exported.span.source)
        if holders is None:
            return None
        if not holders:
            is_closed = made and self._is_own(made) and self._is_closed
            return Unloadable("source", cls, str(cls), _name(element, cls), name, exported) if is_closed else None
        if any(each in holders or self._links(each, holders) for each in made):
            return None
        if not made and not self._is_unmade(name):
            return None
        meant = min(holders)
        return Unloadable("library", library, name, _name(element, cls), self._file_of(meant), self._place_of(meant))

    def _unexported(self, element: Element, cls: Located) -> Unloadable:
        near = nearest(cls, sorted(self._exported), 6) or [
            each for each in self._exported if each.rpartition(":")[2] == cls.rpartition(":")[2]
        ]
        meant = near[0] if len(near) == 1 else ""
        place = self._exported.get(meant) or next(iter(self._exported.values()))
        return Unloadable("class", cls, str(cls), _name(element, cls), meant, place)

    @cached_property
    def _exported(self) -> dict[str, Located]:
        """The classes that the sources of the package export; none where one of them does so in another way."""
        found: dict[str, Located] = {}
        for source in self._sources:
            if not _OTHERS.search(source.text):
                continue
            matches = list(_EXPORTED.finditer(source.text))
            if len(matches) < len(_OTHERS.findall(source.text)):
                return {}
            found.update((each["class"], source.located(*each.span("class"))) for each in matches)
        return found

    @cached_property
    def _sources(self) -> list[Source]:
        paths = (path for path in self._files.tree.walked_below(self._package.folder) if path.endswith(CPP))
        return [each for each in (self._files.tree.read(path, judged=False) for path in paths) if each is not None]

    @cached_property
    def _targets(self) -> dict[str, set[str]]:
        """The targets of the package -> the paths of their sources."""
        found: dict[str, set[str]] = {}
        for build in self._builds:
            folder = os.path.dirname(build.source.absolute)
            for target, paths in build.targets.items():
                known = found.setdefault(target, set())
                known.update(os.path.normpath(os.path.join(folder, path)) for path in paths)
        return found

    @cached_property
    def _is_closed(self) -> bool:
        """Whether all targets and their sources are known."""
        is_open = any(build.open_targets or build.names_computed for build in self._builds)
        return not is_open and all(build.executables_known for build in self._builds)

    def _targets_of(self, name: str) -> list[str]:
        """The targets of the workspace whose file has a name."""
        builds = [build for package in self._workspace.packages.values() for build in package.builds]
        renamed = [target for build in builds for target, file in build.output_names.items() if file == name]
        plain = [name for build in builds if name in build.targets and name not in build.output_names]
        return list(dict.fromkeys([*renamed, *plain]))

    def _is_own(self, targets: Iterable[str]) -> bool:
        return all(target in self._targets for target in targets)

    def _holders(self, source: Source) -> set[str] | None:
        """The libraries that a source is compiled into; None when that is not known."""
        base = os.path.basename(source.name)
        if base.endswith(CPP_HEADERS) or sum(each.basename == base for each in self._sources) > 1:
            return None
        found = {target for target, paths in self._targets.items() if source.absolute in paths}
        if self._namings[base] != len(found):
            return None
        is_included = any(re.search(rf"#\s*include[^\n]*[/\"<]{re.escape(base)}", each.text) for each in self._sources)
        libraries = {name for build in self._builds for name in build.libraries}
        return None if is_included or not found <= libraries else found

    @cached_property
    def _namings(self) -> Counter[str]:
        """The last names of sources -> how many commands have them, besides those that compile tests."""
        found: Counter[str] = Counter()
        for build in self._builds:
            for command in commands(build.source):
                if not (command.name.startswith(_ADDS) and "test" in command.name):
                    found.update({os.path.basename(word) for word in command.arguments if word.endswith(CPP)})
        return found

    def _links(self, target: str, holders: set[str]) -> bool:
        """Whether a library brings another one with it, or may hold anything."""
        if target not in self._targets or any(target in build.open_targets for build in self._builds):
            return True
        links = {name: each for build in self._builds for name, each in build.links.items()}
        todo, seen = [target], {target}
        while todo and len(seen) < _DEEP:
            for name in links.get(todo.pop(), ()):
                if name in holders or "$" in name:
                    return True
                if name not in seen:
                    seen.add(name)
                    todo.append(name)
        return False

    def _is_unmade(self, library: str) -> bool:
        """Whether nothing makes a library: no command that is not known names it, and nothing of the tree has it."""
        words = rf"(?<![\w.-]){re.escape(library)}(?![\w-])"
        is_known = all(build.executables_known for build in self._builds)
        is_named = any(re.search(words, build.source.text) for build in self._builds)
        return (is_known or not is_named) and not any(self._files.tree.named(f"lib{library}.so"))

    def _file_of(self, target: str) -> str:
        names = (str(build.output_names[target]) for build in self._builds if target in build.output_names)
        return next(names, target)

    def _place_of(self, target: str) -> Located | None:
        return next((build.libraries[target] for build in self._builds if target in build.libraries), None)


def _path_of(element: Element) -> Located | None:
    return element.parent.get("path") if element.parent is not None and element.parent.local == "library" else None


def _name(element: Element, cls: Located) -> Located:
    return element.get("name") or cls


@kept
def _loaders(files: Files) -> dict[str, list[Located]]:
    """Base class -> the packages under whose names the sources of the tree look for its plugins."""
    found: dict[str, list[Located]] = {}
    paths = (path for path in files.tree.paths if path.endswith(CPP))
    for source in filter(None, (files.tree.read(path, judged=False) for path in paths)):
        for match in _LOADER.finditer(source.text):
            found.setdefault(match["base"], []).append(source.located(*match.span("package")))
    return found


def _public_loader(base: str) -> str:
    """The package under whose name plugins of a public base class are looked for; empty when it is not known."""
    space = base.partition("::")[0]
    return _LOADERS.get(space) or (space if space in _LOADERS else "")
