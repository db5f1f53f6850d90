"""Parameters that a lifecycle node declares whenever it is configured, although it has them since the first time."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import calls_through
from bringup_lint.graph.nodes.sources.with_header import headers
from bringup_lint.model.cpp_source import DeclaredAgain
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_own
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

DEPTH = 3
"""Calls of methods of the same class that are followed."""
_STEP = "on_configure"
_DECLARING = ("declare_parameter", "declare_parameters")
_RETAKES = regex(r"\bundeclare_parameter\b|\bParameterAlreadyDeclared", hints="Declared undeclare_parameter")
_GUARD = regex(r"(?i)has_parameter|declar|first|once|init|configured")

_FAILS = regex(r"FAILURE|ERROR|False")


def declared_again(nodes: Nodes) -> Iterator[DeclaredAgain]:
    """The first unguarded declaration of each function that configures a node."""
    for source in nodes.cpp:
        header = [each.source.text for each in headers(nodes, source.source)] if source.declared_again else []
        if not any(" declare_parameter(" in each for each in header):
            yield from source.declared_again
    for file, node in nodes.node_classes:
        if node.is_lifecycle and _STEP in node.methods and not _RETAKES.search(file.source.text):
            call = _first(nodes.syntax(file), node)
            if call is not None:
                yield DeclaredAgain(file.span_of(call), _STEP)


def _first(syntax: Syntax, node: NodeClass) -> ast.Call | None:
    methods = {name: each.node for name, each in node.methods.items() if isinstance(each.node, ast.FunctionDef)}
    calls = calls_through(methods, _STEP, DEPTH, lambda call: _is_guarded(syntax, call))
    return next((each for each in calls if called_name(each) in _DECLARING and is_own(each.func)), None)


def _is_guarded(syntax: Syntax, call: ast.Call) -> bool:
    """Whether a condition that may know of the first time is around a call or leaves before it, or a handler."""
    function = syntax.function(call)
    inside = list(ast.walk(function)) if function is not None else []
    set_ = (each for each in inside if isinstance(each, ast.Assign) and isinstance(each.value, ast.Constant))
    flags = {ast.unparse(target) for each in set_ for target in each.targets}
    left = (each for each in inside if isinstance(each, ast.If) and _leaves(each) and each.lineno < call.lineno)
    around = [outer for outer, _ in syntax.within(call)]
    tests = [ast.unparse(each.test) for each in (*left, *around) if isinstance(each, ast.If)]
    is_known = any(_GUARD.search(test) or any(flag in test for flag in flags) for test in tests)
    return is_known or any(isinstance(outer, ast.Try) for outer in around)


def _leaves(branch: ast.If) -> bool:
    """Whether a branch leaves the function or this round of its loop, and not for a failure."""
    last = branch.body[-1]
    return isinstance(last, (ast.Return, ast.Continue)) and not _FAILS.search(ast.unparse(last))
