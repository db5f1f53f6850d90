"""The Python sources of nodes in the tree, joined with the packages and launch files that start them."""

from __future__ import annotations

import ast
import os
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import memo
from bringup_lint.graph.modules import modules
from bringup_lint.graph.nodes.resolved.programs import Program
from bringup_lint.graph.nodes.resolved.programs import made
from bringup_lint.graph.nodes.resolved.programs import program_of
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.modules import Modules
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.unused import Unused
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.purpose import of_source
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import is_self
from bringup_lint.parsers.python_node import let_go
from bringup_lint.parsers.python_node import parse
from bringup_lint.parsers.python_node.classes import ROOTS
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.nodes.resolved.interface_fields import InterfaceFields
    from bringup_lint.graph.nodes.sources.message_types import MessageTypes
    from bringup_lint.graph.provenance import Provenance
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.model.cpp_driver import CppDriver
    from bringup_lint.model.cpp_source import CppNode

_TIMERS = regex(r"\bcreate_(?:timer|rate|wall_timer)\b|\bTimer\(|\bcreate_task\b", hints="create_ Timer(")
_RUNNING = (ast.FunctionDef, ast.AsyncFunctionDef, ast.If, ast.Try, ast.For, ast.While, ast.With)
"""Statements of a module that run, or that others may call."""
_UNJUDGED = (Purpose.TEST, Purpose.CI, Purpose.ARCHIVE)
"""Purposes whose sources are not for a robot."""


@dataclass(eq=False)
class Nodes:
    """Asked as ``robot.nodes``: the sources of nodes, with the packages and launch files that start them."""

    files: Files
    launch: Launch
    runners: Callable[[], Runners]
    provenance: Callable[[], Provenance]

    @cached_property
    def sources(self) -> list[NodeSource]:
        """Every Python node source of the tree, its classes linked to those that they build on."""
        return self._modules.files

    @cached_property
    def _modules(self) -> Modules:
        found = self.files.parsed(parse, self.files.of_kind("python-node"))
        modules = Modules(self.files.tree, self.launch.workspace, found, self.files.parsed)
        modules.link()
        return modules

    def let_go(self) -> None:
        """Forget the syntax that belongs to this run alone."""
        if "_modules" in self.__dict__:
            self._modules.let_go()
        if "robot_code" in self.__dict__:
            let_go(file.source for file in self.robot_code if self.is_plain(file))

    @cached_property
    def judged(self) -> list[NodeSource]:
        """Those that findings may be about."""
        return [file for file in self.sources if file.source.judged and file.tree is not None]

    @cached_property
    def with_modules(self) -> list[NodeSource]:
        """Those, and the files of the tree that they import, also through each other, in the order of imports."""
        return self._reached(self.judged)

    def _reached(self, files: list[NodeSource]) -> list[NodeSource]:
        """Files, and those of the tree that they import, also through each other."""
        found = {file.source: file for file in files}
        todo = list(reversed(files))
        while todo:
            new = (each for each in self._modules.imported(todo.pop()) if each.source not in found)
            for file in new:
                found[file.source] = file
                todo.append(file)
        return list(found.values())

    def importers(self, source: Source) -> list[NodeSource]:
        """The files with classes of nodes that import a file, by themselves or through others."""
        return self._importers.get(source, [])

    @cached_property
    def _importers(self) -> dict[Source, list[NodeSource]]:
        found: dict[Source, list[NodeSource]] = {}
        for file in self.judged:
            if any(each.is_node is True for each in file.classes):
                for module in self._reached([file]):
                    if module is not file:
                        found.setdefault(module.source, []).append(file)
        return found

    def __iter__(self) -> Iterator[NodeSource]:
        return iter(self.judged)

    @cached_property
    def cpp(self) -> list[CppNode]:
        """The judged C++ sources of nodes but tests, those that hold a construct of rclcpp."""
        if not self.files.of_kind("cpp-node"):
            return []
        from bringup_lint.parsers.cpp_node import parse as parse_cpp

        sources = (each for each in self.files.of_kind("cpp-node") if each.judged and not each.template)
        programs = [each for each in sources if self.purpose(each) not in _UNJUDGED]
        return self.files.parsed(parse_cpp, programs)

    @cached_property
    def drivers(self) -> list[CppDriver]:
        """The judged C++ sources, of nodes or not, but tests: what they do with the answers of devices."""
        sources = [each for each in self.files.of_kind("cpp-node", "cpp-driver") if each.judged and not each.template]
        if not sources:
            return []
        from bringup_lint.parsers.cpp_driver import parse as parse_driver

        return self.files.parsed(parse_driver, (each for each in sources if self.purpose(each) not in _UNJUDGED))

    @property
    def classes(self) -> Iterator[NodeClass]:
        """The classes of nodes, and the nodes without one, of the judged sources."""
        for file in self.judged:
            yield from (each for each in file.classes if each.is_node is True)

    def file_of(self, node: NodeClass) -> NodeSource:
        return self._modules.by_source[node.source]

    @memo
    def purpose(self, source: Source) -> Purpose:
        """What a source is for, by the path of the file and by that in its package."""
        found = of_source(self._path(source), self.files.purpose(source))
        is_example = found is Purpose.ROBOT and (self._unused.has(source) or self._is_unmade(source))
        return Purpose.EXAMPLE if is_example else found

    def _is_unmade(self, source: Source) -> bool:
        """Whether a file is no program and holds classes alone, and nothing makes one of them."""
        file = self._modules.by_source.get(source)
        body = file.tree.body if file is not None and file.tree is not None else []
        classes = [each.name for each in body if isinstance(each, ast.ClassDef)]
        if not classes or not self._unused.is_no_program(source) or any(isinstance(each, _RUNNING) for each in body):
            return False
        return not any(map(self._unused.makes, classes))

    def lowered(self, source: Source, severity: str) -> str:
        """The severity of a finding in a source: info in code that is only an example. In packages that others wrote it
        stays, other than with ``lowered_if_vendored``."""
        return severity if self.is_for_robot(source) else "info"

    def lowered_if_vendored(self, source: Source, severity: str) -> str:
        """As ``lowered``, and info in what others wrote, as its package or a folder of it says."""
        return "info" if self.launch.workspace.is_vendored(source) else self.lowered(source, severity)

    @cached_property
    def _unused(self) -> Unused:
        return Unused(self.files, self.launch.workspace)

    def runs_main(self, source: Source) -> bool:
        """Whether something may start a file as a program, rather than only import it."""
        return not self._unused.is_no_program(source)

    def is_for_robot(self, source: Source) -> bool:
        return self.purpose(source) is Purpose.ROBOT

    def _path(self, source: Source) -> str:
        """The path from the folder of the package on; the last two components when that is not known."""
        owner = self.launch.workspace.owner(source)
        path = source.absolute
        if owner is not None:
            return os.path.relpath(path, os.path.dirname(owner.folder))
        return "/".join(path.split("/")[-2:]) if os.path.isabs(source.name) else source.name

    def program(self, package: str, executable: str) -> Program | None:
        """The source of ``ros2 run package executable``; None when it is not Python, or not in the tree."""
        key = (package, executable)
        if key not in self._programs:
            self._programs[key] = program_of(self.launch.workspace, self._modules, package, executable)
        return self._programs[key]

    @cached_property
    def _programs(self) -> dict[tuple[str, str], Program | None]:
        return {}

    def program_of(self, started: Started) -> Program | None:
        """The source of what a launch file or command starts."""
        package, executable = literal_text(started.package), literal_text(started.executable)
        return self.program(str(package), str(executable)) if package and executable else None

    @cached_property
    def _starters(self) -> dict[NodeClass, list[Started]]:
        found: dict[NodeClass, list[Started]] = {}
        for started, program in self._launched_programs:
            for node in program.classes:
                found.setdefault(node, []).append(started)
        return found

    @cached_property
    def _by_file(self) -> dict[Source, list[Started]]:
        found: dict[Source, list[Started]] = {}
        for started, program in self._launched_programs:
            found.setdefault(program.file.source, []).append(started)
        return found

    @cached_property
    def _launched_programs(self) -> list[tuple[Started, Program]]:
        """The programs of the tree that launch files start, each with the action that does."""
        found = ((started, self.program_of(started)) for started in self.launch.nodes)
        return [(started, program) for started, program in found if program is not None]

    def launched(self, file: NodeSource) -> list[Started]:
        """The launch actions that run a file as a program."""
        return self._by_file.get(file.source, [])

    def module_named(self, dotted: str, file: NodeSource) -> NodeSource | None:
        """The file of the tree that a module is for the imports of another file."""
        return self._modules.module(dotted, file)

    def imported(self, file: NodeSource) -> list[NodeSource] | None:
        """A file and all of the workspace that it imports; None when part of that is not found."""
        return self._modules.closure(file)

    @memo
    def made(self, file: NodeSource) -> list[NodeClass]:
        """The nodes that the code of a file makes, also of classes of other files."""
        return list(dict.fromkeys(made(self._modules, file, None)))

    def makers(self, node: NodeClass) -> list[NodeSource]:
        """The files of the tree that make a node of this class."""
        return self._makers.get(node, [])

    @cached_property
    def _makers(self) -> dict[NodeClass, list[NodeSource]]:
        found: dict[NodeClass, list[NodeSource]] = {}
        for file in self.sources:
            if file.tree is None:
                continue
            for node in self.made(file):
                found.setdefault(node, []).append(file)
        return found

    @cached_property
    def robot_sources(self) -> list[NodeSource]:
        """The judged sources but tests: those whose ends are looked at."""
        return [file for file in self.judged if self.purpose(file.source) not in _UNJUDGED]

    @cached_property
    def robot_code(self) -> list[NodeSource]:
        """Those, and the Python modules of the tree that are no nodes themselves, but tests. In a tree without nodes
        these are the programs that units and the like start, and what they import."""
        found = [*self.robot_sources, *self.with_modules, *(self._plain if self.sources else self._started_plain)]
        code = (each for each in found if each.tree is not None and each.source.judged)
        return [each for each in dict.fromkeys(code) if self.purpose(each.source) not in _UNJUDGED]

    @property
    def _plain(self) -> Iterator[NodeSource]:
        paths = (source.absolute for source in modules(self.files) if "/." not in f"/{source.name}")
        return (each for each in map(self._modules.at, paths) if each is not None)

    @property
    def _started_plain(self) -> list[NodeSource]:
        from bringup_lint.graph.nodes.sources.started_programs import started_programs

        paths = [source.absolute for source in started_programs(self.files, self.runners())]
        return self._reached([each for each in map(self._modules.at, paths) if each is not None])

    def is_plain(self, file: NodeSource) -> bool:
        """Whether a file is none of the sources of nodes, but a module or program beside them."""
        return file not in self._known

    @cached_property
    def _known(self) -> frozenset[NodeSource]:
        return frozenset(self.sources)

    def is_idle(self, file: NodeSource, function: str | None) -> bool:
        """Whether a function that nothing of its file calls is called by no other file either, as far as is looked."""
        return not self.is_plain(file) or function is None or not self._unused.is_in_others(function)

    @property
    def node_classes(self) -> Iterator[tuple[NodeSource, NodeClass]]:
        """The classes of nodes in the judged sources but tests, each with its file."""
        for file in self.robot_sources:
            yield from ((file, node) for node in file.classes if node.is_node is True)

    def threads(self, node: NodeClass) -> str:
        """Whether ``one`` thread runs the callbacks of a node or ``several``; empty when no file spins it."""
        texts = [file.source.text for file in (self.file_of(node), *self.makers(node))]
        if any("MultiThreadedExecutor" in text or "EventsExecutor" in text for text in texts):
            return "several"
        return "one" if any("spin" in text for text in texts) else ""

    def without_timer(self, file: NodeSource) -> list[NodeClass]:
        """The nodes that a program makes, when surely none of them has a timer; else empty."""
        made = self.made(file)
        lineages = [each for node in made for each in node.lineage]
        known = all(each.is_node is True and self._is_followed(each) for each in lineages)
        texts = {each.source.text for each in lineages} | {file.source.text}
        if not known or any(_TIMERS.search(text) for text in texts):
            return []
        return made

    def _is_followed(self, node: NodeClass) -> bool:
        """Whether all that a class builds on is known."""
        return node.name is None or node.base is not None or all(base in ROOTS for base in node.bases)

    @cached_property
    def interfaces(self) -> InterfaceFields:
        from bringup_lint.graph.nodes.resolved.interface_fields import InterfaceFields

        return InterfaceFields(self.files.tree, self.launch.workspace)

    @cached_property
    def message_types(self) -> list[MessageTypes]:
        """The types of the expressions of each program that imports messages."""
        from bringup_lint.graph.nodes.sources.message_types import types_of

        found = (types_of(file, self.syntax(file), self.interfaces) for file in self.robot_sources)
        return [types for types in found if types is not None]

    @cached_property
    def set_elsewhere(self) -> set[str]:
        """Attributes that code of the tree sets on something else than ``self``."""
        attributes = (each for file in self.sources for each in file.nodes if isinstance(each, ast.Attribute))
        return {each.attr for each in attributes if isinstance(each.ctx, ast.Store) and not is_self(each.value)}

    def syntax(self, file: NodeSource) -> Syntax:
        return self.ending(file).syntax

    @memo
    def ending(self, file: NodeSource) -> Ending:
        """How the programs of a file end."""
        syntax = file.source.kept((Syntax, file), lambda: Syntax(file)) if file.is_alone else Syntax(file)
        syntax.reached.clear()
        return Ending(syntax, self.files.target.ros)

    def started(self, node: NodeClass) -> list[Started]:
        """The launch actions that start a node of this class, each as its own file starts it."""
        return self._starters.get(node, [])
