"""What the models of Python files share."""

from __future__ import annotations

import ast
import warnings
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Sequence
from typing import Union

from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import TypeGuard

_DEEP = 40
"""Levels of what is compared as it is written."""
FunctionNode = Union["ast.FunctionDef", "ast.AsyncFunctionDef"]
PlacedNode = Union["ast.expr", "ast.stmt", "ast.keyword", "ast.arg", "ast.excepthandler", "ast.alias"]
"""The nodes of a syntax tree that have a place in the text; those of operators, contexts and clauses have none."""


def syntax_of(text: str) -> ast.Module | None:
    """The tree of a text, without the warnings of Python about it; None when it is not Python."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


_PLAIN = frozenset(
    "arg asname attr conversion ctx id is_async kind level module op ops simple type_comment type_ignores".split()
)
"""The fields that hold names, numbers, or what has no place in the text: contexts and operators."""
_FIELDS: dict[type[ast.AST], tuple[str, ...]] = {ast.Constant: ()}
_BINDING = frozenset(("name", "rest", "type_params"))
"""The fields that hold a name, or names, that the node binds."""
_BINDS: dict[type[ast.AST], bool] = {}
"""Whether syntax of a kind may bind names by itself: most does not."""


def fields_of(node: ast.AST) -> tuple[str, ...]:
    """The fields of a node in which other nodes may be that have a place in the text, or hold such nodes."""
    kind = type(node)
    if kind not in _FIELDS:
        _FIELDS[kind] = tuple(name for name in kind._fields if name not in _PLAIN)
    return _FIELDS[kind]


def children(node: ast.AST) -> Sequence[ast.AST]:
    """As ``ast.iter_child_nodes``, without contexts and operators. The node keeps them: a tree is walked some ten
    times."""
    kept: Sequence[ast.AST] | None = getattr(node, "below", None)
    if kept is None:
        kept = node.below = _children(node)  # type: ignore[attr-defined]
    return kept


def _children(node: ast.AST) -> Sequence[ast.AST]:
    found: list[ast.AST] = []
    for name in fields_of(node):
        value = getattr(node, name, None)
        if isinstance(value, ast.AST):
            found.append(value)
        elif isinstance(value, list):
            found += [child for child in value if isinstance(child, ast.AST)]
    return found or ()


def is_self(node: ast.AST | None) -> bool:
    return isinstance(node, ast.Name) and node.id == "self"


def is_own(node: ast.AST | None) -> TypeGuard[ast.Attribute]:
    """Whether a node is an attribute of the own object: ``self.name``."""
    return isinstance(node, ast.Attribute) and is_self(node.value)


def last_name(node: ast.AST | None) -> str:
    """The last part of a name; empty of everything else."""
    return getattr(node, "attr", getattr(node, "id", ""))


def called_name(call: ast.Call) -> str:
    """The last part of the name of what is called; empty where that has none."""
    return last_name(call.func)


def dotted_name(node: ast.AST) -> str:
    """``name`` or ``Class.name``; empty for what is longer, and for everything else."""
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
        return f"{node.value.id}.{node.attr}"
    return node.id if isinstance(node, ast.Name) else ""


def written(node: ast.AST) -> str:
    """A node as it is written; empty where it is deeper than names are, which ``ast.unparse`` may fail on."""
    level: Sequence[ast.AST] = [node]
    for _ in range(_DEEP):
        level = [child for each in level for child in children(each)]
        if not level:
            return ast.unparse(node)
    return ""


def walk(node: ast.AST) -> Iterator[ast.AST]:
    """As ``ast.walk``, breadth first, without contexts and operators."""
    found = [node]
    for each in found:
        found += children(each)
        yield each


def bound_names(node: ast.AST) -> Iterable[str]:
    """The names that a node binds by itself, where it stands or, as ``global`` does, further out."""
    kind = type(node)
    if kind is ast.Name:
        return () if type(node.ctx) is ast.Load else (node.id,)  # type: ignore[attr-defined]
    if kind not in _BINDS:
        _BINDS[kind] = not _BINDING.isdisjoint(kind._fields) or kind in (ast.arg, ast.Global, ast.Nonlocal)
    return _named(node) if _BINDS[kind] else ()


def _named(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.arg):
        yield node.arg
    elif isinstance(node, ast.alias):
        yield node.asname or node.name.partition(".")[0]
    elif isinstance(node, (ast.Global, ast.Nonlocal)):
        yield from node.names
    else:  # definitions, handlers, patterns and parameters of types; the name of an attribute is in another field
        name = getattr(node, "name", None) or getattr(node, "rest", None)
        if isinstance(name, str):
            yield name
        yield from (str(each.name) for each in getattr(node, "type_params", ()))
