"""The texts with which the sources of a program may name its parameters, in Python or C++."""

from __future__ import annotations

import ast
import os
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from functools import partial
from functools import reduce
from operator import or_
from typing import TYPE_CHECKING

from bringup_lint.dataclass import replace
from bringup_lint.facts.ros.brought import is_released
from bringup_lint.facts.ros.parameters import declared_by
from bringup_lint.facts.ros.parameters import hands_parameters
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.nodes.nodes import Nodes
from bringup_lint.graph.nodes.resolved.programs import Program
from bringup_lint.graph.topics.sources.cpp_files import CppFiles
from bringup_lint.graph.topics.sources.cpp_files import packages_included
from bringup_lint.graph.topics.sources.cpp_files import stem
from bringup_lint.graph.workspace import Package
from bringup_lint.graph.workspace import Workspace
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.package import Build
from bringup_lint.model.parameter_words import ParameterWords
from bringup_lint.parsers.python_node.classes import ROOTS
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

CPP_FILES = 300
"""C++ files of one program that are read."""
_CLASS = regex(r"\b(?:class|struct)\s+[\w\s]{1,120}:(?P<bases>[^:{};()](?:[^{};()]|::){0,400})\{", hints="class struct")
_CLASS_NAME = regex(r"\b(?:class|struct)\s+(?:[A-Z][A-Z_]+\s+)?(\w+)", hints="class struct")
_NODE = regex(r"\brclcpp(?:_lifecycle)?::(?:Lifecycle)?Node\b", hints="rclcpp")
_ACCESS = regex(r"\b(?:public|virtual|private|protected)\b|\s")
_BASES = frozenset({"rclcpp::Node", "Node", "rclcpp_lifecycle::LifecycleNode", "LifecycleNode"})
_MADE = regex(r"\b(?P<name>\w{1,80})\s*[=({]\s*(?:std::)?make_shared\s*<", hints="make_shared")
_TYPED = regex(
    r"\brclcpp(?:_lifecycle)?::(?:Lifecycle)?Node(?:::\w{0,20}Ptr)?(?:\s{1,4}const)?\s{0,4}>?\s{0,4}[&*]{0,2}\s{0,4}"
    r"(?P<name>\w{1,80})\s{0,4}[,;)=({]",
    hints="rclcpp",
)
"""A variable or an argument that is a node."""
_ALIAS = regex(r"\b(?P<name>\w{1,80})\s{0,4}=\s{0,4}(?:this\b|rclcpp(?:_lifecycle)?::(?:Lifecycle)?Node::make_shared)")
_HANDED = regex(
    r"\b(?:shared_from_this|weak_from_this|get_node_\w+_interface)\s*\(|(?:\b(?P<call>\w{1,80})\s{0,20}[({]|[({]"
    r"|(?P<member>&\s?[\w:]{1,120}\s?)?,)\s{0,20}\*?(?:this->)?(?P<what>\w{1,80})(?:\s?(?:\.|->)\s?get\(\s?\))?\s{0,20}(?=[,)}])"
)
"""A call that gives the node itself, or a word that is given to a call; after a member function it is its object."""
_NODES = regex(r"this|(?:\w+_)?[nN]ode(?:_|_?[pP]tr_?|_?[hH]andle_?)?|p?nh_?")
"""Names of what stands for a node."""
_OWN_CALLS = frozenset({"spin", "spin_some", "spin_until_future_complete", "add_node", "remove_node", "reset", "move"})
_SAFE = ("rclpy", "rclpy_action", "tf2_ros", "message_filters", "diagnostic_updater", "cv_bridge", "builtins", "super")
"""Python modules that are handed a node and declare nothing of their own."""


class ParameterNames:
    """Reads for each program the words with which it may ask for parameters, once."""

    def __init__(self, files: Files, workspace: Workspace, nodes: Nodes, cpp_files: CppFiles) -> None:
        self._files = files
        self._cpp_files = cpp_files
        self._workspace = workspace
        self._nodes = nodes
        self._known: dict[tuple[str, str], ParameterWords | None] = {}

    def of(self, started: Started) -> ParameterWords | None:
        """None when not everything is known that may declare a parameter in the program."""
        package, word = literal_text(started.package), started.program
        return self.of_program(str(package), str(word)) if package is not None and word is not None else None

    def of_program(self, package: str, program: str) -> ParameterWords | None:
        """``program``: an executable or component class."""
        key = (package, program)
        if key not in self._known:
            self._known[key] = self._of(package, program)
        return self._known[key]

    def sources_of(self, started: Started) -> set[str]:
        """The C++ files that the build description of its package makes a program of, and those of headers that they
        include."""
        package, word = self._workspace.packages.get(str(literal_text(started.package))), started.program
        made = _made(package, str(word)) if package is not None and word is not None else None
        return self._used(package, made) if package is not None and made else set()

    @property
    def all(self) -> Iterator[ParameterWords]:
        """What is known of every program of the workspace."""
        for package in self._workspace.packages.values():
            components = {name for build in package.builds for name in build.components}
            built = {name for build in package.builds for name in build.built}
            for program in sorted({*package.executables, *built, *components}):
                words = self.of_program(package.name, program)
                if words is not None:
                    yield words

    def _of(self, package: str, program: str) -> ParameterWords | None:
        python = self._nodes.program(package, program)
        if python is not None:
            return self._python(python)
        owner = self._workspace.packages.get(package)
        if owner is not None or package in self._workspace.ambiguous:
            return self._cpp(owner, program) if owner is not None else None
        known = declared_by(package, program)
        return ParameterWords(known) if known is not None else None

    def _python(self, program: Program) -> ParameterWords | None:
        lineage = [each for node in program.classes for each in node.lineage]
        if not lineage or not all(each.is_node and self._is_followed(each.bases, each.base) for each in lineage):
            return None
        return self._python_file(program.file)

    def _python_file(self, file: NodeSource) -> ParameterWords | None:
        """The same for a file and all that it imports."""
        from bringup_lint.parsers.python_node.parameter_words import parse

        files = self._nodes.imported(file)
        if files is None or any(_hands_out(each, self._workspace) for each in files):
            return None
        return _joined(self._words(parse, each.source) for each in files)

    def may_be_declared_for(self, name: Located) -> bool:
        """Whether a node that imports the file of a name declares that parameter, or is not known: modules ask nodes
        that others hand to them."""
        words = (self._python_file(file) for file in self._nodes.importers(name.span.source))
        return any(each is None or each.name(name) for each in words)

    @staticmethod
    def _is_followed(bases: tuple[str, ...], base: object) -> bool:
        return base is not None or not bases or all(each in ROOTS or each == "object" for each in bases)

    def _cpp(self, package: Package, program: str) -> ParameterWords | None:
        from bringup_lint.parsers.cpp_node.parameter_words import parse

        made = _made(package, program)
        if any(self._cpp_files.source(path) is None for path in made or ()):
            return None
        sources = self._with_included(package, self._own(package, made)) if made is not None else None
        if made is None or sources is None or not _is_plain_node(sources):
            return None
        used = self._used(package, made)
        found = ((source, self._words(parse, source)) for source in sources)
        return _joined(words if source.absolute in used else replace(words, unset=()) for source, words in found)

    def _words(self, parse: Callable[[Source], ParameterWords], source: Source) -> ParameterWords:
        if source not in self._parsed:
            self._parsed[source] = next(iter(self._files.parsed(parse, [source])), ParameterWords(open=True))
        return self._parsed[source]

    @cached_property
    def _parsed(self) -> dict[Source, ParameterWords]:
        return {}

    def _own(self, package: Package, made: set[str]) -> list[str]:
        """The files of the package that a program may be made of, but not those of other programs."""
        used, every = self._used(package, made), self._cpp_files.of_package(package)
        return [path for path in every if path in used or not made or not self._cpp_files.is_program(path)]

    def _used(self, package: Package, made: set[str]) -> set[str]:
        return made | self._implementing(package, made)

    def _implementing(self, package: Package, made: set[str]) -> set[str]:
        """The files that are called like a header which some files, or such files, include."""
        by_stem = self._cpp_files.by_stem(package)
        found: set[str] = set()
        todo = list(made)
        while todo:
            included = map(stem, self._cpp_files.includes(todo.pop()))
            new = {path for name in included for path in by_stem.get(name, ())} - found - made
            found |= new
            todo += new
        return found

    def _with_included(self, package: Package, paths: list[str]) -> list[Source] | None:
        """Files, and those of the packages of the workspace that they include; None when there are too many, or when
        others that they include may declare parameters in a node that some of the files hand out."""
        depends = {str(name) for _, name in package.manifest.depends}
        is_open = False
        found: dict[str, Source] = {}
        todo, seen = list(paths), {package.name}
        while todo:
            path = todo.pop()
            source = self._cpp_files.source(path) if path not in found else None
            if source is None:
                continue
            found[path] = source
            if len(found) > CPP_FILES:
                return None
            for name in packages_included(source) - seen:
                seen.add(name)
                other = self._workspace.packages.get(name)
                if other is not None:
                    depends |= {str(each) for _, each in other.manifest.depends}
                    todo += self._cpp_files.of_package(other)
                elif (name in depends or is_released(name)) and hands_parameters(name):
                    is_open = True
        sources = list(found.values())
        return None if is_open and (any(map(_hands_node, sources)) or _builds_on_others(sources)) else sources


def _made(package: Package, program: str) -> set[str] | None:
    """The sources of an executable or component; None when the package does not build it, empty when they are not
    known."""
    for build in package.builds:
        target = build.components.get(program, program)
        if target in build.targets:
            return set(_made_of(build, target))
    return None


def _made_of(build: Build, target: str) -> Iterator[str]:
    """The sources of a target and of those that it links."""
    folder = os.path.dirname(build.source.absolute)
    todo, seen = [target], {target}
    while todo:
        current = todo.pop()
        yield from (os.path.normpath(os.path.join(folder, file)) for file in build.targets.get(current, ()))
        for name in build.links.get(current, ()):
            if name in build.targets and name not in seen:
                seen.add(name)
                todo.append(name)


def _joined(words: Iterable[ParameterWords]) -> ParameterWords | None:
    found = reduce(or_, words, ParameterWords(declared=frozenset()))
    return None if found.is_open else found


def _bases(source: Source) -> list[str]:
    """What the classes of a C++ file build on."""
    return [found["bases"] for found in _CLASS.finditer(source.text)]


def _builds_on_others(sources: list[Source]) -> bool:
    """Whether a class builds on one that is neither of the sources nor of the libraries of C++ and of nodes."""
    names = {name for source in sources for name in _CLASS_NAME.findall(source.text)}
    texts = (bases for source in sources for bases in source.once(_bases, partial(_bases, source)))
    bases = {_ACCESS.sub("", each).partition("<")[0] for text in texts for each in text.split(",")}
    return any(not each.startswith("std::") and each.rpartition("::")[2] not in names for each in bases - _BASES)


def _hands_node(source: Source) -> bool:
    """Whether a C++ file gives a node to a call that may be one of another package."""
    return bool(source.once(_hands_node, partial(_find_handed, source)))


def _find_handed(source: Source) -> bool:
    made = {found["name"] for each in (_MADE, _TYPED, _ALIAS) for found in each.finditer(source.text)}
    for found in _HANDED.finditer(source.text):
        what = found["what"]
        if what is None:
            return True
        is_node = what in made or _NODES.fullmatch(what) is not None
        if is_node and found["call"] not in _OWN_CALLS and not found["member"]:
            return True
    return False


def _is_plain_node(sources: list[Source]) -> bool:
    """Whether the nodes of the sources build on those of rclcpp alone."""
    classes = [bases for source in sources for bases in source.once(_bases, partial(_bases, source))]
    bases = [_ACCESS.sub("", each) for text in classes for each in text.split(",")]
    named = (base for base in bases if base not in _BASES and not base.startswith("BT::"))
    odd = [base for base in named if base.partition("<")[0].endswith("Node")]
    return not odd and any(source.matches(_NODE) for source in sources)


def _hands_out(file: NodeSource, workspace: Workspace) -> bool:
    """Whether a file gives a node to something that is not in the tree and may declare parameters in it."""
    if file.tree is None:
        return True
    for call in file.nodes:
        if not isinstance(call, ast.Call) or not any(map(_is_node, _given(call))):
            continue
        top, dot, _ = (file.qualified(call.func) or "").partition(".")
        if top and dot and top not in workspace.packages and top not in _SAFE and hands_parameters(top):
            return True
    return False


def _given(call: ast.Call) -> list[ast.expr]:
    return [*call.args, *(key.value for key in call.keywords)]


def _is_node(value: ast.expr) -> bool:
    return isinstance(value, ast.Name) and value.id in ("self", "node")
