"""Loops in which the constructors of nodes stay until the program ends."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.callbacks.stopped_callbacks import never_run
from bringup_lint.graph.nodes.sources.endless_loops import has_no_exit
from bringup_lint.graph.nodes.sources.endless_loops import is_forever
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.cpp_source import MakingLoop
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import is_self
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_SPINS = regex(r"spin|executor|exit\(|shutdown\(|abort\(", re.I, "spin executor exit( shutdown( abort(")
"""Words of a class that runs its callbacks itself, or ends the program."""
_INTERRUPTS = frozenset({"KeyboardInterrupt", "ExternalShutdownException"})


def making_loops(nodes: Nodes) -> Iterator[list[MakingLoop]]:
    """Those of one source together, without the loops by which callbacks of the node never run."""
    told = {each.loop.loop for each in never_run(nodes)}
    for file in nodes.robot_sources:
        if "while" not in file.source.text:
            continue
        syntax = nodes.syntax(file)
        found = [each for cls in file.classes if cls.is_node for each in _of_class(syntax, cls, told)]
        if found:
            yield found
    for source in nodes.cpp:
        if source.making_loops:
            yield source.making_loops


def _of_class(syntax: Syntax, cls: NodeClass, told: set[ast.While]) -> Iterator[MakingLoop]:
    made = cls.methods.get("__init__")
    if made is None or cls.name is None or _SPINS.search(cls.span.text):
        return
    for loop in _loops(syntax, made.node, told):
        yield MakingLoop(_head(syntax, loop), str(cls.name), None)
    for call in _own_calls(made.node):
        method = cls.methods.get(call.func.attr) if isinstance(call.func, ast.Attribute) else None
        if method is None or isinstance(method.node, ast.AsyncFunctionDef) or method.decorators:
            continue
        for loop in _loops(syntax, method.node, told):
            yield MakingLoop(_head(syntax, loop), str(cls.name), syntax.file.span_of(call))


def _own_calls(function: ast.AST) -> Iterator[ast.Call]:
    """The calls of methods on ``self`` that are statements of a function."""
    for each in _statements(function):
        call = each.value if isinstance(each, ast.Expr) else None
        if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Attribute):
            continue
        if is_self(call.func.value):
            yield call


def _loops(syntax: Syntax, function: ast.AST, told: set[ast.While]) -> Iterator[ast.While]:
    for each in _statements(function):
        if isinstance(each, ast.While) and each not in told and is_forever(syntax, each) and has_no_exit(each):
            yield each


def _statements(function: ast.AST) -> Iterator[ast.stmt]:
    """The statements that a function comes to whatever is the case, also those in a ``with``."""
    todo = list(getattr(function, "body", ()))
    while todo:
        each = todo.pop(0)
        yield each
        if isinstance(each, ast.With) or (isinstance(each, ast.Try) and _only_ends(each)):
            todo = [*each.body, *todo]
        if any(isinstance(inner, (ast.Return, ast.Raise)) for inner in walk(each)):
            return


def _only_ends(block: ast.Try) -> bool:
    """Whether only the end of the program leaves a block, so that no exception of its own ends a loop in it."""
    return all(_INTERRUPTS.issuperset(_caught(each.type)) for each in block.handlers)


def _caught(kind: ast.expr | None) -> list[str]:
    """The last names of the exceptions that a handler takes; an empty one for all of them."""
    kinds = kind.elts if isinstance(kind, ast.Tuple) else [kind]
    return [written(each).rpartition(".")[2] if each is not None else "" for each in kinds]


def _head(syntax: Syntax, loop: ast.While) -> Span:
    """``while ...`` without its body."""
    start, end = syntax.file.span_of(loop).start, syntax.file.span_of(loop.test).end
    return syntax.file.source.span(start, end)
