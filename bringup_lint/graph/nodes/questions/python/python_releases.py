"""What a node source needs of Python, against the Python that its distribution runs on."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache

from bringup_lint.facts import table
from bringup_lint.facts.ros import distros
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.named_tuple import NamedTuple

_PYTHONS = {"focal": (3, 8), "jammy": (3, 10), "noble": (3, 12)}
"""Source: packages.ubuntu.com, python3."""
_CAUGHT = frozenset({"AttributeError", "Exception", "BaseException"})
_GENERIC = frozenset({"list", "dict", "set", "frozenset", "tuple", "type"})


class _Refusal(NamedTuple):
    reason: str
    present: str


class NotThere(NamedTuple):
    node: ast.expr | ast.stmt
    what: str
    """The name or form, and when it came or went."""
    present: str
    """What the robot has: ``runs on 3.10``, ``has NumPy 1.26``."""
    raises: str
    """The exception that ends it."""
    late: bool = False
    """Only where the line runs, and not when the file is read."""


def python_of(distribution: str | None) -> tuple[int, int] | None:
    """The release of Python that a distribution is built for."""
    found = distros.every().get(distribution or "")
    return _PYTHONS.get(found.codename) if found is not None else None


def not_there(syntax: Syntax, python: tuple[int, int]) -> Iterator[NotThere]:
    """The imports and forms that a release of Python refuses, outside of tests of the release and of ``try``."""
    lazy = any(dotted == "__future__.annotations" for dotted in syntax.file.imports.values())
    names = _refused(python)
    ends = frozenset(name.rpartition(".")[2] for name in names)
    for node in syntax.file.nodes:
        found = next(_imports(node, names), None) or _attribute(syntax, node, names, ends)
        if found is None and python < (3, 10):
            found = _form(node, python, lazy)
        if found is not None and not _is_guarded(syntax, found.node):
            yield found


@cache
def _refused(python: tuple[int, int]) -> dict[str, _Refusal]:
    """The names that a release does not have yet, or not any more."""
    runs = f"{python[0]}.{python[1]}"
    found = {}
    for row in table("ros/python_since"):
        if row["since"] and python < _release(row["since"]):
            found[row["name"]] = _Refusal(f"came with Python {row['since']}", f"runs on {runs}")
        elif row["removed"] and python >= _release(row["removed"]):
            taken = row["by"] or f"Python {row['removed']}"
            present = f"has {row['present']}" if row["present"] else f"runs on {runs}"
            found[row["name"]] = _Refusal(f"is gone since {taken}", present)
    return found


def _release(text: str) -> tuple[int, int]:
    major, minor = text.split(".")
    return int(major), int(minor)


def _refusal(node: ast.expr | ast.stmt, name: str, refusal: _Refusal, raises: str, *, late: bool = False) -> NotThere:
    return NotThere(node, f"{name} {refusal.reason}", refusal.present, raises, late)


def _imports(node: ast.AST, names: dict[str, _Refusal]) -> Iterator[NotThere]:
    if isinstance(node, ast.Import):
        for alias in node.names:
            if alias.name in names:
                yield _refusal(node, alias.name, names[alias.name], "ModuleNotFoundError")
    if isinstance(node, ast.ImportFrom) and node.level == 0:
        if node.module in names:
            yield _refusal(node, node.module, names[node.module], "ModuleNotFoundError")
        for alias in node.names:
            dotted = f"{node.module}.{alias.name}"
            if dotted in names:
                yield _refusal(node, dotted, names[dotted], "ImportError")


def _attribute(syntax: Syntax, node: ast.AST, names: dict[str, _Refusal], ends: frozenset[str]) -> NotThere | None:
    """``asyncio.timeout`` after ``import asyncio``, where nothing in the file sets it. ``ends``: the last words of the
    names, by which nearly all attributes are told apart."""
    if not isinstance(node, ast.Attribute) or not isinstance(node.ctx, ast.Load):
        return None
    if node.attr not in ends:
        return None
    dotted = syntax.file.qualified(node)
    if dotted not in names or node.attr in syntax.once(_set) or syntax.catches(node, _CAUGHT):
        return None
    return _refusal(node, dotted, names[dotted], "AttributeError", late=syntax.function(node) is not None)


def _set(syntax: Syntax) -> frozenset[str]:
    """The attributes that a file sets, or asks for with ``hasattr()`` and the like."""
    stored = (each.attr for each in syntax.file.nodes if isinstance(each, ast.Attribute) and _is_set(each))
    texts = (each.value for each in syntax.file.nodes if isinstance(each, ast.Constant) and isinstance(each.value, str))
    return frozenset((*stored, *texts))


def _is_set(node: ast.Attribute) -> bool:
    return not isinstance(node.ctx, ast.Load)


def _form(node: ast.AST, python: tuple[int, int], lazy: bool) -> NotThere | None:
    runs = f"runs on {python[0]}.{python[1]}"
    if isinstance(node, ast.Match):
        return NotThere(node.subject, "match came with Python 3.10", runs, "SyntaxError")
    annotations = _annotations(node) if not lazy else ()
    for annotation in annotations:
        for each in ast.walk(annotation):
            if isinstance(each, ast.BinOp) and isinstance(each.op, ast.BitOr):
                return NotThere(each, "X | Y as a type came with Python 3.10", runs, "TypeError")
            if python < (3, 9) and isinstance(each, ast.Subscript) and _is_builtin(each.value):
                return NotThere(each, "list[X] came with Python 3.9", runs, "TypeError")
    return None


def _annotations(node: ast.AST) -> list[ast.expr]:
    """The annotations that are evaluated when a function is defined."""
    if not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
        return []
    arguments = (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)
    return [each for each in (*(one.annotation for one in arguments), node.returns) if each is not None]


def _is_builtin(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id in _GENERIC


def _is_guarded(syntax: Syntax, node: ast.AST) -> bool:
    return any(isinstance(outer, (ast.If, ast.Try)) for outer, _ in syntax.above(node))
