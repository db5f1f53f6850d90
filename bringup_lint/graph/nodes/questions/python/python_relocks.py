"""Locks of Python classes that a thread asks for while it holds them already."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.python import is_own
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

DEPTH = 3
"""Calls that are followed to another lock."""
_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)
_CHOICES = (ast.If, ast.For, ast.AsyncFor, ast.While, ast.Match, ast.ExceptHandler)


class PythonRelock(NamedTuple):
    file: NodeSource
    place: ast.expr
    """The call that leads to the second lock, or that lock."""
    held: ast.expr
    again: ast.expr
    lock: str
    """``self._lock``."""
    through: str | None
    """The method that is called; None when the function itself locks twice."""


def python_relocks(nodes: Nodes) -> Iterator[list[PythonRelock]]:
    """Those of one lock of a class together."""
    for file in nodes.robot_sources:
        if "Lock" in file.source.text:
            for each in file.nodes:
                if isinstance(each, ast.ClassDef):
                    yield from _Class(file, each).relocks()


class _Class:
    def __init__(self, file: NodeSource, node: ast.ClassDef) -> None:
        self._file = file
        self._methods: dict[str, list[ast.FunctionDef]] = {}
        for each in node.body:
            if isinstance(each, ast.FunctionDef):
                self._methods.setdefault(each.name, []).append(each)
        self._locks = self._plain_locks(node)
        self._known: dict[tuple[str, str, int], ast.expr | None] = {}
        """What is known of a method, a lock and a depth."""

    def _plain_locks(self, node: ast.ClassDef) -> frozenset[str]:
        """The attributes that hold nothing but a lock which its owner may not take again."""
        made: dict[str, set[str | None]] = {}
        for each in ast.walk(node):
            targets = each.targets if isinstance(each, ast.Assign) else [getattr(each, "target", None)]
            for target in targets:
                if is_own(target):
                    value = getattr(each, "value", None)
                    kind = self._file.qualified(value.func) if isinstance(value, ast.Call) else None
                    made.setdefault(target.attr, set()).add(kind)
        return frozenset(f"self.{name}" for name, kinds in made.items() if kinds == {"threading.Lock"})

    def relocks(self) -> Iterator[list[PythonRelock]]:
        found: dict[str, list[PythonRelock]] = {}
        for method in (methods[0] for methods in self._methods.values() if self._locks):
            for block, _ in _run(method):
                for lock in self._taken(block):
                    again = self._again(block, written(lock))
                    if again is not None:
                        name = written(lock)
                        place, second, through = again
                        relock = PythonRelock(self._file, place, lock, second, name, through)
                        found.setdefault(name, []).append(relock)
        yield from found.values()

    def _taken(self, node: ast.AST) -> list[ast.expr]:
        items = node.items if isinstance(node, ast.With) else []
        return [each.context_expr for each in items if written(each.context_expr) in self._locks]

    def _again(self, block: ast.AST, lock: str) -> tuple[ast.expr, ast.expr, str | None] | None:
        """The first place inside a ``with`` that asks for its lock again, unless something gives it back."""
        inner = [each for each, _ in _run(block)]
        if any(isinstance(each, ast.Attribute) and each.attr == "release" for each in inner):
            return None
        for each in inner:
            second = next((taken for taken in self._taken(each) if written(taken) == lock), None)
            if second is not None:
                return second, second, None
            second = self._locked_by(each, lock, DEPTH)
            if second is not None and isinstance(each, ast.Call):
                return each, second, self._called(each)
        return None

    def _called(self, node: ast.AST) -> str | None:
        """The method of the own class that a call runs."""
        function = node.func if isinstance(node, ast.Call) else None
        if is_own(function):
            return function.attr if len(self._methods.get(function.attr, [])) == 1 else None
        return None

    def _locked_by(self, call: ast.AST, lock: str, depth: int) -> ast.expr | None:
        """Where the method that a call runs takes a lock, whenever it does not return before."""
        name = self._called(call)
        if name is None or depth == 0:
            return None
        key = (name, lock, depth)
        if key not in self._known:
            self._known[key] = self._locked_in(name, lock, depth)
        return self._known[key]

    def _locked_in(self, name: str, lock: str, depth: int) -> ast.expr | None:
        for each, is_certain in _run(self._methods[name][0]):
            if is_certain:
                second = next((taken for taken in self._taken(each) if written(taken) == lock), None)
                second = second or self._locked_by(each, lock, depth - 1)
                if second is not None:
                    return second
        return None


def _run(function: ast.AST) -> Iterator[tuple[ast.AST, bool]]:
    """What a function or block runs itself, in the order of the text, and whether no condition decides about it."""
    todo = [(each, True) for each in reversed(list(ast.iter_child_nodes(function)))]
    while todo:
        node, is_certain = todo.pop()
        if not isinstance(node, _FUNCTIONS):
            yield node, is_certain
            is_inner = is_certain and not isinstance(node, _CHOICES)
            todo += [(each, is_inner) for each in reversed(list(ast.iter_child_nodes(node)))]
