"""Classes that a program makes although a method of theirs is still abstract."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import bound_names
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


_ABSTRACT = frozenset(
    {"abc.abstractmethod", "abc.abstractproperty", "abc.abstractclassmethod", "abc.abstractstaticmethod"}
)
_META = frozenset({"abc.ABC", "abc.ABCMeta"})
_EMPTY = frozenset({"abc.ABC", "object", "typing.Generic", "rclpy.node.Node", "threading.Thread"})
"""Classes of others that define none of the methods that a class of the tree may ask for."""
_LINEAGE = 20
_STEPS = 3
"""Files through which a name is followed."""


class Unfinished(NamedTuple):
    """A call that makes a class, or hands it to the function that does."""

    file: NodeSource
    call: ast.Call
    made: str
    of: NodeSource
    """The file of the class."""
    cls: ast.ClassDef
    base: NodeSource
    method: FunctionNode
    """The abstract method that nothing defines."""


class _Class(NamedTuple):
    file: NodeSource
    node: ast.ClassDef


def unfinished_classes(nodes: Nodes) -> Iterator[Unfinished]:
    """The classes that are made although Python refuses it."""
    if not any("abstract" in file.source.text for file in nodes.with_modules):
        return
    known = _Classes(nodes)
    for file in nodes.robot_sources:
        syntax = nodes.syntax(file)
        for call in syntax.calls:
            for named in (call.func, *(call.args if _takes_classes(known, file, call) else ())):
                found = known.of(named, file)
                missing = known.missing(found) if found is not None else None
                if found is not None and missing is not None and not syntax.is_dead(call):
                    yield Unfinished(file, call, found.node.name, found.file, found.node, *missing)


def _takes_classes(known: _Classes, file: NodeSource, call: ast.Call) -> bool:
    """Whether the function that is called makes what its first argument is: ``main = create_main(RoverNode)``."""
    function = known.function(call.func, file) if len(call.args) == 1 and isinstance(call.args[0], ast.Name) else None
    if function is None or len(function.args.args) != 1:
        return False
    name = function.args.args[0].arg
    return any(isinstance(each, ast.Call) and _is_name(each.func, name) for each in walk(function))


def _is_name(node: ast.AST, name: str) -> bool:
    return isinstance(node, ast.Name) and node.id == name


class _Classes:
    """The classes of the tree, and what of them is abstract."""

    def __init__(self, nodes: Nodes) -> None:
        self._nodes = nodes
        self._tops: dict[NodeSource, dict[str, ast.stmt | None]] = {}
        self._missing: dict[ast.ClassDef, tuple[NodeSource, FunctionNode] | None] = {}

    def of(self, node: ast.expr, file: NodeSource) -> _Class | None:
        """The class that an expression names."""
        found = self._found(node, file)
        return _Class(found[0], found[1]) if found is not None and isinstance(found[1], ast.ClassDef) else None

    def function(self, node: ast.expr, file: NodeSource) -> ast.FunctionDef | None:
        found = self._found(node, file)
        return found[1] if found is not None and isinstance(found[1], ast.FunctionDef) else None

    def _found(self, node: ast.expr, file: NodeSource) -> tuple[NodeSource, ast.stmt] | None:
        if isinstance(node, ast.Name) and node.id not in file.imports:
            return self._top(node.id, file, _STEPS)
        dotted = file.qualified(node) if isinstance(node, (ast.Name, ast.Attribute)) else None
        return self._imported(dotted, file, _STEPS) if dotted is not None else None

    def _imported(self, dotted: str, file: NodeSource, steps: int) -> tuple[NodeSource, ast.stmt] | None:
        name = dotted.rpartition(".")[2]
        module = dotted.removesuffix(name)
        module = module.rstrip(".") if module.strip(".") else module
        other = self._nodes.module_named(module, file) if module and steps else None
        return self._top(name, other, steps - 1) if other is not None else None

    def _top(self, name: str, file: NodeSource, steps: int) -> tuple[NodeSource, ast.stmt] | None:
        """What has a name at the top of a file, where one statement alone gives it."""
        if file not in self._tops:
            self._tops[file] = _definitions(file)
        found = self._tops[file].get(name)
        if found is not None:
            return file, found
        target = file.imports.get(name) if name not in self._tops[file] else None
        return self._imported(target, file, steps) if target is not None else None

    def missing(self, cls: _Class) -> tuple[NodeSource, FunctionNode] | None:
        """The first abstract method of a class that nothing of it defines; None where that is not known."""
        if cls.node not in self._missing:
            self._missing[cls.node] = self._first_missing(cls)
        return self._missing[cls.node]

    def _first_missing(self, cls: _Class) -> tuple[NodeSource, FunctionNode] | None:
        lineage = self._lineage(cls)
        if not any(_has_meta(each) for each in lineage):
            return None
        bodies = [(each.file, bound) for each in lineage for bound in _bound(each.node)]
        whole = {name for file, (name, node) in bodies if not _is_abstract(file, node)} | self._nodes.set_elsewhere
        for file, (name, node) in bodies:
            if name not in whole and isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
                return file, node
        return None

    def _lineage(self, cls: _Class) -> list[_Class]:
        """A class and all that it builds on; nothing when one of them is not known."""
        found = [cls]
        for each in found:
            if each.node.decorator_list or len(found) > _LINEAGE:
                return []
            for base in each.node.bases:
                plain = base.value if isinstance(base, ast.Subscript) else base
                other = self.of(plain, each.file)
                if other is not None:
                    found += [other] if other not in found else []
                elif (each.file.qualified(plain) or written(plain)) not in _EMPTY:
                    return []
        return found


def _definitions(file: NodeSource) -> dict[str, ast.stmt | None]:
    """Name -> the class or function of that name; None where another statement gives it too."""
    found: dict[str, ast.stmt | None] = {}
    body = file.tree.body if file.tree is not None else []
    for statement in body:
        if isinstance(statement, (ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
            found[statement.name] = None if statement.name in found else statement
        elif not isinstance(statement, (ast.Import, ast.ImportFrom)):
            found.update(dict.fromkeys(name for each in walk(statement) for name in bound_names(each)))
    return found


def _bound(cls: ast.ClassDef) -> Iterator[tuple[str, ast.AST]]:
    """The names that the body of a class gives, each with what gives it."""
    todo: list[ast.AST] = list(reversed(cls.body))
    while todo:
        node = todo.pop()
        yield from ((name, node) for name in bound_names(node))
        if not isinstance(node, (*FUNCTIONS, ast.ClassDef)):
            todo.extend(ast.iter_child_nodes(node))


def _is_abstract(file: NodeSource, node: ast.AST) -> bool:
    decorators = node.decorator_list if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) else ()
    return any(file.qualified(each) in _ABSTRACT for each in decorators)


def _has_meta(cls: _Class) -> bool:
    """Whether Python looks after the abstract methods of a class."""
    given = (*cls.node.bases, *(each.value for each in cls.node.keywords if each.arg == "metaclass"))
    return any(cls.file.qualified(each) in _META for each in given)
