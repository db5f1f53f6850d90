"""The code that the callbacks of a node run."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.ending import statements_of
from bringup_lint.graph.nodes.sources.sending import called
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import is_own

DEPTH = 3


def code_of(ending: Ending, cls: NodeClass, callback: Callback) -> tuple[str, list[ast.AST]]:
    """The name and the statements of a callback that is in the file of its class."""
    if callback.function is not None:
        return "a lambda", [callback.function.body]
    if callback.name is None:
        return "", []
    method = cls.methods.get(callback.name)
    if method is not None:
        return callback.name, body_of(method.node)
    return callback.name, statements_of(ending, ast.Name(callback.name), None)


def reached(syntax: Syntax, body: list[ast.AST], cls: NodeClass) -> list[ast.AST]:
    """The syntax that a callback runs: its own, and that of the methods and functions of the file that it calls."""
    key = (cls, *body)
    if key not in syntax.reached:
        syntax.reached[key] = list(_entered(syntax, body, cls, {}))
    return syntax.reached[key]


def reached_once(
    ending: Ending, cls: NodeClass, callbacks: Iterable[Callback]
) -> Iterator[tuple[Callback, str, ast.AST]]:
    """The syntax that callbacks run, each with the first of them and its name. A function that all of them call is read
    once."""
    entered: dict[ast.AST, int] = {}
    for callback in callbacks:
        name, body = code_of(ending, cls, callback)
        for node in _entered(ending.syntax, body, cls, entered):
            yield callback, name, node


def _entered(syntax: Syntax, body: list[ast.AST], cls: NodeClass, entered: dict[ast.AST, int]) -> Iterator[ast.AST]:
    """The syntax of a body and of the functions that it calls, without those that were ``entered`` as near before."""
    todo = [(body, 0)]
    while todo:
        statements, depth = todo.pop()
        for node in own(statements):
            yield node
            if isinstance(node, ast.Call) and depth < DEPTH and _is_plain(node):
                for function, owner in called(syntax, node, cls):
                    if entered.get(function, DEPTH + 1) > depth + 1 and (owner is None or owner.source is cls.source):
                        entered[function] = depth + 1
                        todo.append((body_of(function), depth + 1))


def _is_plain(call: ast.Call) -> bool:
    """Whether a call is one of ``self`` or of a function, of which it is known what it runs."""
    function = call.func
    return isinstance(function, ast.Name) or is_own(function)


def only_stores(ending: Ending, cls: NodeClass, callback: Callback) -> bool:
    """Whether a callback does no more than keep what it got, so that nothing is lost when it runs later."""
    name, body = code_of(ending, cls, callback)
    kept = (ast.Assign, ast.AnnAssign, ast.AugAssign, ast.Pass)
    return bool(name and body) and all(_is_docstring(each) or isinstance(each, kept) for each in body)


def _is_docstring(node: ast.AST) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
