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
    """Whether a condition that may know of the first time is around a call, or a handler."""
    return any(
        isinstance(outer, ast.Try) or (isinstance(outer, ast.If) and _GUARD.search(ast.unparse(outer.test)) is not None)
        for outer, _ in syntax.within(call)
    )
