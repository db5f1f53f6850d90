"""Parameters that a lifecycle node declares whenever it is configured, although it has them since the first time."""

from __future__ import annotations

import ast
import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import calls_through
from bringup_lint.graph.nodes.sources.with_header import headers
from bringup_lint.model.declared_again import GUARD
from bringup_lint.model.declared_again import RETAKES
from bringup_lint.model.declared_again import DeclaredAgain
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_own
from bringup_lint.model.python import written
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

DEPTH = 3
"""Calls of methods of the same class that are followed."""
_STEP = "on_configure"
_DECLARING = ("declare_parameter", "declare_parameters")
_FAILS = regex(r"FAILURE|ERROR|False")


def declared_again(nodes: Nodes) -> Iterator[DeclaredAgain]:
    """The first unguarded declaration of each function that configures a node."""
    for source in nodes.cpp:
        header = [each.source.text for each in headers(nodes, source.source)] if source.declared_again else []
        if not any(" declare_parameter(" in each for each in header):
            yield from source.declared_again
    for file, node in nodes.node_classes:
        if node.is_lifecycle and _STEP in node.methods and not RETAKES.search(file.source.text):
            call = _first(nodes.syntax(file), node)
            if call is not None:
                yield DeclaredAgain(file.span_of(call), _STEP)


def _first(syntax: Syntax, node: NodeClass) -> ast.Call | None:
    methods = {name: each.node for name, each in node.methods.items() if isinstance(each.node, ast.FunctionDef)}
    calls = calls_through(methods, _STEP, DEPTH, _Guards(syntax).of)
    return next((each for each in calls if called_name(each) in _DECLARING and is_own(each.func)), None)


class _Guards:
    """What is around calls and before them; each function is looked at once."""

    def __init__(self, syntax: Syntax) -> None:
        self._syntax = syntax
        self._functions: dict[int, tuple[set[int], float]] = {}

    def of(self, call: ast.Call) -> bool:
        """Whether a condition that may know of the first time is around a call or leaves before it, or a handler."""
        knowing, left = self._of_function(self._syntax.function(call))
        around = [outer for outer, _ in self._syntax.within(call)]
        return left < call.lineno or any(isinstance(each, ast.Try) or id(each) in knowing for each in around)

    def _of_function(self, function: ast.AST | None) -> tuple[set[int], float]:
        """The conditions of a function that may know of the first time, and the line of the first that leaves."""
        if id(function) not in self._functions:
            inside = list(ast.walk(function)) if function is not None else []
            fixed = (each for each in inside if isinstance(each, ast.Assign) and isinstance(each.value, ast.Constant))
            flags = {written(target) for each in fixed for target in each.targets}
            branches = [each for each in inside if isinstance(each, ast.If) and _knows(each, flags)]
            left = min((each.lineno for each in branches if _leaves(each)), default=math.inf)
            self._functions[id(function)] = {id(each) for each in branches}, left
        return self._functions[id(function)]


def _knows(branch: ast.If, flags: set[str]) -> bool:
    test = written(branch.test)
    return GUARD.search(test) is not None or any(flag in test for flag in flags)


def _leaves(branch: ast.If) -> bool:
    """Whether a branch leaves the function or this round of its loop, and not for a failure."""
    last = branch.body[-1]
    return isinstance(last, (ast.Return, ast.Continue)) and not _FAILS.search(written(last))
