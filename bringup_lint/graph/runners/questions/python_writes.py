"""The folders and logs of its own that a Python program makes as it starts."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.model.python import called_name
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import byte_order_mark
from bringup_lint.parsers.python_syntax import tree_of
from bringup_lint.source import Source
from bringup_lint.source import Span

_MAKING_CALLS = frozenset({"makedirs", "mkdir"})
_KEEPING_CALLS = frozenset({"FileHandler", "RotatingFileHandler", "TimedRotatingFileHandler", "WatchedFileHandler"})
_AT_START = ("__init__", "main")


def python_writes(source: Source) -> Iterator[tuple[Span, str]]:
    """The folders that a program makes and the logs that it opens, outside of any ``try``, as it starts."""
    tree = tree_of(source)
    if tree is None:
        return
    texts = _texts(tree)
    positions = Positions(source, byte_order_mark(source))
    for call in _calls(tree.body):
        name = called_name(call)
        if name in _MAKING_CALLS | _KEEPING_CALLS and call.args:
            path = _path(call.args[0], texts)
            if path is not None:
                yield positions.span(call), path


def _texts(tree: ast.Module) -> dict[str, str]:
    """The names of the module that have one text as their value."""
    found: dict[str, set[str | None]] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.setdefault(node.id, set())
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            value = node.value.value if isinstance(node.value, ast.Constant) else None
            found.setdefault(node.targets[0].id, set()).add(value if isinstance(value, str) else None)
    return {name: text for name, values in found.items() if len(values) == 1 and (text := next(iter(values)))}


def _calls(body: Iterable[ast.stmt]) -> Iterator[ast.Call]:
    """The calls that surely run as the program starts."""
    for statement in body:
        if isinstance(statement, ast.ClassDef):
            yield from _calls(statement.body)
        elif isinstance(statement, ast.FunctionDef):
            if statement.name in _AT_START:
                yield from _calls(statement.body)
        elif isinstance(statement, (ast.Expr, ast.Assign)):
            yield from (each for each in ast.walk(statement) if isinstance(each, ast.Call))


def _path(value: ast.expr, texts: dict[str, str]) -> str | None:
    if isinstance(value, ast.Constant):
        return value.value if isinstance(value.value, str) else None
    if isinstance(value, ast.Name):
        return texts.get(value.id)
    if isinstance(value, ast.Call) and called_name(value) == "dirname" and len(value.args) == 1:
        inner = _path(value.args[0], texts)
        return inner.rpartition("/")[0] if inner is not None else None
    return None
