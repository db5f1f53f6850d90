"""Calls of the functions, methods and classes of the tree whose arguments do not fit."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.idle import is_late
from bringup_lint.graph.nodes.sources.object_classes import object_classes
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.tree_imports import bindings
from bringup_lint.graph.nodes.sources.tree_imports import definitions
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import is_own
from bringup_lint.model.python import written
from bringup_lint.model.python_calls import misfit
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
_EXPECTED = frozenset({"TypeError"})
_CAUGHT = frozenset({"Exception", "BaseException"})


class UnfitCall(NamedTuple):
    file: NodeSource
    call: ast.Call
    called: str
    """``self.drive``, ``Motor``."""
    wrong: str
    """What is wrong, in words."""
    definition: FunctionNode
    defined: NodeSource
    """The file that defines it."""
    function: str | None
    """Where it is called; None: when the file is loaded."""
    caught: bool
    idle: bool


def unfit_calls(nodes: Nodes) -> Iterator[UnfitCall]:
    overridden = _overridden(nodes)
    for file in nodes.robot_code:
        yield from _in_file(nodes, file, overridden)


def _overridden(nodes: Nodes) -> set[tuple[str, str]]:
    """The names of the classes on which others of the tree build, each with the methods that these define."""
    classes = (each for file in nodes.sources for each in file.nodes if isinstance(each, ast.ClassDef))
    return {
        (written(base).rpartition(".")[2], method.name)
        for each in classes
        for base in each.bases
        for method in _methods(each)
    }


def _methods(owner: ast.ClassDef) -> Iterator[FunctionNode]:
    return (each for each in owner.body if isinstance(each, _FUNCTIONS))


def _in_file(nodes: Nodes, file: NodeSource, overridden: set[tuple[str, str]]) -> Iterator[UnfitCall]:
    syntax = nodes.syntax(file)
    known = _Known(nodes, file, syntax, overridden)
    for call in syntax.calls:
        found = known.of(call)
        if found is None or syntax.catches(call, _EXPECTED) or syntax.is_dead(call):
            continue
        wrong = misfit(call, found.function.args, found.is_method)
        if wrong is not None:
            function = syntax.function(call)
            named = function.name if function is not None else None
            idle = is_idle(syntax, call) or is_late(syntax, call)
            caught = syntax.catches(call, _CAUGHT)
            called = written(call.func)
            yield UnfitCall(file, call, called, wrong, found.function, found.file, named, caught, idle)


class _Called(NamedTuple):
    file: NodeSource
    function: FunctionNode
    is_method: bool


class _Known:
    """The functions, methods and classes of one file, and those that it imports, that have one meaning each."""

    def __init__(self, nodes: Nodes, file: NodeSource, syntax: Syntax, overridden: set[tuple[str, str]]) -> None:
        self._file = file
        self._syntax = syntax
        self._overridden = overridden
        self._imported = definitions(nodes, file)
        self._objects = object_classes(nodes, file)
        self._bound = bindings(nodes, file)
        self._stored = {
            each.attr for each in file.nodes if isinstance(each, ast.Attribute) and not isinstance(each.ctx, ast.Load)
        }
        body = file.tree.body if file.tree is not None else []
        self._functions = {each.name: each for each in body if isinstance(each, _FUNCTIONS)}
        self._classes = {each.name: each for each in body if isinstance(each, ast.ClassDef)}
        self._methods: dict[ast.ClassDef, dict[str, list[FunctionNode]]] = {}

    def of(self, call: ast.Call) -> _Called | None:
        """What a call surely runs, when that has no decorators."""
        if isinstance(call.func, ast.Name):
            found = self._of_other(call.func.id) or self._own_called(self._named(call.func.id))
        elif is_own(call.func):
            found = self._own_called(self._method(self._syntax.definition(call), call.func.attr))
        else:
            found = self._of_object(call.func)
        return found if found is not None and not found.function.decorator_list else None

    def _own_called(self, function: FunctionNode | None) -> _Called | None:
        if function is None:
            return None
        return _Called(self._file, function, isinstance(self._syntax.definition(function), ast.ClassDef))

    def _of_other(self, name: str) -> _Called | None:
        """What another file of the tree defines."""
        found = self._imported.get(name)
        if found is None:
            return None
        if not isinstance(found.node, ast.ClassDef):
            return _Called(found.file, found.node, is_method=False)
        function = self._constructor(found.node)
        return _Called(found.file, function, is_method=True) if function is not None else None

    def _of_object(self, called: ast.expr) -> _Called | None:
        """The method of an object of the tree."""
        found = self._objects.of(called.value) if isinstance(called, ast.Attribute) else None
        if found is None or not isinstance(called, ast.Attribute) or called.attr in self._stored:
            return None
        function = self._objects.method(found, called.attr)
        return _Called(found.file, function, is_method=True) if function is not None else None

    def _named(self, name: str) -> FunctionNode | None:
        if self._bound[name] != 1:
            return None
        owner = self._classes.get(name)
        return self._functions.get(name) if owner is None else self._constructor(owner)

    def _constructor(self, owner: ast.ClassDef) -> FunctionNode | None:
        if owner.decorator_list or owner.keywords or self._own(owner, "__new__") is not None:
            return None
        return self._own(owner, "__init__")

    def _method(self, owner: ast.ClassDef | None, name: str) -> FunctionNode | None:
        if owner is None or name in self._stored or (owner.name, name) in self._overridden:
            return None
        return self._own(owner, name)

    def _own(self, owner: ast.ClassDef, name: str) -> FunctionNode | None:
        """The method of a class that its body defines once."""
        if owner not in self._methods:
            self._methods[owner] = {}
            for each in _methods(owner):
                self._methods[owner].setdefault(each.name, []).append(each)
        found = self._methods[owner].get(name, [])
        return found[0] if len(found) == 1 else None
