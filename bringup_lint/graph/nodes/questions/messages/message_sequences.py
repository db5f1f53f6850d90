"""Messages that are used as if they were the list that one of their fields is."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.message_types import MessageTypes
from bringup_lint.graph.nodes.sources.what_ends import end_of
from bringup_lint.named_tuple import NamedTuple

_EXPECTED = frozenset({"TypeError"})
_CAUGHT = frozenset({"Exception", "BaseException"})


class UsedAsList(NamedTuple):
    value: ast.expr
    """The message."""
    type: str
    needed: str
    """What it has not: ``elements``, ``a length``."""
    lists: tuple[str, ...]
    """Its fields that are lists."""
    end: str
    idle: bool


def used_as_lists(types: MessageTypes) -> Iterator[UsedAsList]:
    syntax = types.syntax
    for node in types.file.nodes:
        for value, needed in _sequences(node):
            kind = types.of(value)
            fields = types.interfaces.fields(kind) if kind is not None and "/" in kind and kind[-1] != "]" else None
            if kind is not None and fields and not syntax.is_dead(value) and not syntax.catches(value, _EXPECTED):
                lists = tuple(name for name, of in fields.items() if of.endswith("]"))
                end = end_of(syntax, value, caught=syntax.catches(value, _CAUGHT))
                yield UsedAsList(value, kind, needed, lists, end, is_idle(syntax, value))


def _sequences(node: ast.AST) -> Iterator[tuple[ast.expr, str]]:
    """What a piece of syntax uses as a list, and for what."""
    if isinstance(node, ast.Subscript):
        yield node.value, "elements"
    elif isinstance(node, (ast.For, ast.comprehension)):
        yield node.iter, "elements"
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "len":
        yield from ((each, "a length") for each in node.args)
