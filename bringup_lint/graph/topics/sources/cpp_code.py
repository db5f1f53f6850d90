"""From an executable or component of a package to its C++ sources, by what CMakeLists.txt builds them from."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.topics.sources.code import Code
from bringup_lint.graph.topics.sources.cpp_files import CppFiles
from bringup_lint.graph.topics.sources.whole_programs import WholePrograms
from bringup_lint.graph.workspace import Package
from bringup_lint.model.cpp_source import CppNode
from bringup_lint.model.package import Build
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

FILES = 40
"""Files of one program that are read."""


class CppCode:
    """Reads the sources of each C++ program once."""

    def __init__(self, files: Files, cpp_files: CppFiles, whole: WholePrograms) -> None:
        self._files = files
        self._cpp_files = cpp_files
        self._whole = whole
        self._known: dict[tuple[str, str], Code | None] = {}
        self._read: dict[str, CppNode | None] = {}

    @property
    def sources(self) -> list[Source]:
        """What was read."""
        return [node.source for node in self._read.values() if node is not None]

    def code(self, package: Package, program: str) -> Code | None:
        """``program``: an executable or component class. None when its sources are not known, or make several nodes."""
        key = (package.folder, program)
        if key not in self._known:
            self._known[key] = self._code(package, program)
        return self._known[key]

    def _code(self, package: Package, program: str) -> Code | None:
        for build in package.builds:
            library = build.components.get(program)
            if library is not None:
                plugin = build.main_plugins.get(program) or (program if "::" in program else _plugin_of(build, library))
                return self._joined(package, library, self._component(build, library, plugin)) if plugin else None
            if program in build.targets:
                return self._joined(package, program, self._executable(build, program))
        return None

    def _executable(self, build: Build, program: str) -> list[CppNode]:
        own = list(self._nodes(build, program))
        if any(node.endpoints for node in own):
            return own
        libraries = dict.fromkeys(name for name in build.links.get(program, ()) if name in build.targets)
        linked = [node for library in libraries for node in self._nodes(build, library)]
        return own + _included(own, linked)

    def _component(self, build: Build, library: str, plugin: str) -> list[CppNode]:
        """The file that registers the class; the only file of its library when no other is registered in it."""
        nodes = list(self._nodes(build, library))
        own = [node for node in nodes if plugin in node.components or plugin.rpartition("::")[2] in node.components]
        return own if len(own) == 1 and len(own[0].components) == 1 else []

    def _nodes(self, build: Build, target: str) -> Iterator[CppNode]:
        folder = os.path.dirname(build.source.absolute)
        for file in build.targets.get(target, ())[:FILES]:
            path = os.path.normpath(os.path.join(folder, file))
            if path not in self._read:
                self._read[path] = self._parse(path)
            found = self._read[path]
            if found is not None:
                yield found

    def _parse(self, path: str) -> CppNode | None:
        if not self._files.tree.walks(path):
            return None
        source = self._cpp_files.known.get(path) or self._files.tree.read(path, "cpp-node")
        if source is None or source.template or "Node" not in source.text:
            return None
        from bringup_lint.parsers.cpp_node import parse

        return next(iter(self._files.parsed(parse, [source])), None)

    def _joined(self, package: Package, target: str, nodes: list[CppNode]) -> Code | None:
        """One program of several files; nothing when they hold several classes of nodes."""
        classes = {name for node in nodes for name in node.classes}
        endpoints = [endpoint for node in nodes for endpoint in node.endpoints]
        names = [name for node in nodes for name in node.names]
        if not nodes or len(classes) > 1 or not (endpoints or names):
            return None
        whole = self._whole.is_whole(package, target, nodes)
        return Code(names[0] if len(names) == 1 else None, None, endpoints, whole, None, nodes[0].source)


def _plugin_of(build: Build, library: str) -> str | None:
    plugins = [name for name, place in build.components.items() if place == library and "::" in name]
    return plugins[0] if len(plugins) == 1 else None


def _included(own: list[CppNode], linked: list[CppNode]) -> list[CppNode]:
    """The files of a library that a program uses: of one with several nodes those whose headers it includes."""
    if sum(bool(node.names) for node in linked) < 2:
        return linked
    text = "".join(node.source.text for node in own)
    return [node for node in linked if f"{os.path.splitext(node.source.basename)[0]}.h" in text]
