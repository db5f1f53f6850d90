"""The files that a launch file names: includes, parameter files, and paths in parameters and arguments."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Iterator

from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.resolve import Resolver
from bringup_lint.graph.launch.scope import Scope
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.launch.unknown_folders import last_name
from bringup_lint.graph.workspace import Found
from bringup_lint.graph.workspace import Package
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import children
from bringup_lint.model.launch_values import text
from bringup_lint.model.launch_values import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span


class Reference(NamedTuple):
    kind: str
    """``include``, ``parameters`` or ``path``."""
    value: Value
    span: Span
    name: str
    """The file's own name."""
    found: Found
    optional: bool
    """Under a condition that is open, or off by default."""
    aborts: bool = False
    """launch itself opens the file: it fills in substitutions, or reads the values for a component."""
    key: str = ""
    """The parameter or launch argument that a path is the value of."""
    given: bool = False
    """The node gets other parameters, too, beside its description and its clock."""

    @property
    def where(self) -> Span:
        """Where the name of the file is, if the path takes several lines, else the path."""
        if self.span.line == self.span.end_position.line:
            return self.span
        texts = (literal_text(each) for each in walk(self.value))
        ends = [each.span for each in texts if each is not None and each.rpartition("/")[2] == self.name]
        return next((each for each in reversed(ends) if self.span.start <= each.start < self.span.end), self.span)

    def path_in(self, package: Package) -> str:
        """The path in the package, as far as it is known."""
        where = place(self.value)
        if where is not None and where.base == "share":
            return where.path
        return os.path.relpath(where.path, package.folder) if where is not None and where.base == "file" else self.name


_READERS = ("open", "xacro.process_file")
_CATCHES = regex(r"(?m)^[ \t]*except\b", hints="except")
_OF_ANY_NODE = ("use", "robot")
"""How ``use_sim_time`` and ``robot_description`` begin."""
Find = Callable[[Value], "Found | None"]


def references(expansion: Expansion, file: LaunchFile, find: Find) -> Iterator[Reference]:
    for include in expansion.includes:
        found = find(include.file) if include.source is file else None
        if found is not None:
            yield Reference(
                "include", include.file, include.action.file.span, _name(include.file), found, bool(include.conditions)
            )
    for node in expansion.nodes:
        if node.file is file:
            yield from _of_node(node, find)
    yield from _passed(expansion, file, find)
    yield from _opened(file, find)


def _opened(file: LaunchFile, find: Find) -> Iterator[Reference]:
    """What the code of a launch file reads itself, without catching that it is missing."""
    resolver = Resolver(Scope())
    for call in file.calls:
        path, *mode = (resolver.value(each) for each in call.arguments) if call.name in _READERS else (None,)
        found = find(path) if path is not None and not any((text(each) or "r") != "r" for each in mode[:1]) else None
        if path is not None and found is not None and not file.source.says(_CATCHES):
            yield Reference("path", path, path.span, _name(path), found, False, True)


def _passed(expansion: Expansion, file: LaunchFile, find: Find) -> Iterator[Reference]:
    """Paths that includes are given, and the defaults of arguments, which may reach one that is not in the tree."""
    for include in expansion.includes:
        if include.source is file:
            for name, value in include.values.items():
                yield from _paths(value, find, bool(include.conditions), name)
    resolver = Resolver(Scope())
    for declared in expansion.declared:
        if declared.file is file and declared.action.default is not None:
            default = resolver.value(declared.action.default)
            yield from _paths(default, find, bool(declared.conditions), declared.name)


def _of_node(node: Started, find: Find) -> Iterator[Reference]:
    optional = node.by_default is not True
    component = isinstance(node.action, ComposableNode)
    for source in node.parameters:
        substitutes = isinstance(source, ParameterFile) and source.allow_substs is not None
        aborts = component or substitutes or isinstance(source, DerivedFile)
        value = base_of(source)
        found = find(value)
        if found is not None:
            given = any(_gives(each, find) for each in node.parameters if each is not source)
            yield Reference("parameters", value, value.span, _name(value), found, optional, aborts, given=given)
        else:
            yield from _paths(value, find, optional)
    for value in node.arguments:
        yield from _paths(value, find, optional)


def _gives(source: Value, find: Find) -> bool:
    """Whether a source of parameters sets more of a node than its description and its clock."""
    if isinstance(source, DictValue):
        return any((text(name) or "").partition("_")[0] not in _OF_ANY_NODE for name, _ in source.items)
    found = find(base_of(source))
    return found is not None and found.file is not None


def base_of(source: Value) -> Value:
    while isinstance(source, (ParameterFile, DerivedFile)):
        source = source.file if isinstance(source, ParameterFile) else source.base
    return source


def _paths(value: Value, find: Find, optional: bool, key: str = "") -> Iterator[Reference]:
    """Every path inside a value that is relative to a package or to this file."""
    if isinstance(value, (PathJoin, Concat)):
        found = find(value)
        if found is not None:
            yield Reference("path", value, value.span, _name(value), found, optional, key=key)
            return
    if isinstance(value, DictValue):
        for name, inner in value.items:
            yield from _paths(inner, find, optional, text(name) or key)
        return
    for inner in children(value):
        yield from _paths(inner, find, optional, key)


def _name(value: Value) -> str:
    where = place(value)
    return (where.path if where is not None else text(value) or last_name(value)).rpartition("/")[2]
