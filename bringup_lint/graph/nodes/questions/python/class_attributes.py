"""Attributes of objects that a Python file takes from their class, which has none of these."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.what_ends import end_of
from bringup_lint.model.python import bound_names
from bringup_lint.model.python import is_self
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple

_BASES = frozenset({"object", "rclpy.node.Node"})
_CAUGHT = frozenset({"AttributeError", "Exception", "BaseException"})


class OfClass(NamedTuple):
    place: ast.Attribute
    owner: str
    set_at: ast.Attribute
    """Where an object gets it."""
    end: str
    """What the exception ends, in words."""


def class_attributes(syntax: Syntax) -> Iterator[OfClass]:
    """The first such use of each attribute."""
    tree = syntax.file.tree
    classes = {each.name: each for each in tree.body if isinstance(each, ast.ClassDef)} if tree is not None else {}
    others = (each for each in syntax.file.nodes if not isinstance(each, ast.ClassDef))
    rebound = {name for each in others for name in bound_names(each) if name in classes}
    known = {name: _set(each) for name, each in classes.items() if name not in rebound and _is_plain(syntax, each)}
    stored = {
        (_owner(each), each.attr)
        for each in syntax.file.nodes
        if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Store)
    }
    seen: set[tuple[str, str]] = set()
    for node in syntax.file.nodes:
        if not isinstance(node, ast.Attribute) or not isinstance(node.ctx, ast.Load):
            continue
        name = _owner(node)
        set_at = known.get(name, {}).get(node.attr)
        if set_at is None or {(name, node.attr), ("cls", node.attr)} & stored or (name, node.attr) in seen:
            continue
        if not syntax.is_dead(node) and not syntax.catches(node, _CAUGHT):
            seen.add((name, node.attr))
            yield OfClass(node, name, set_at, end_of(syntax, node))


def _owner(node: ast.AST) -> str:
    """The name of what an attribute is taken from; empty for other expressions."""
    value = getattr(node, "value", None)
    return value.id if isinstance(value, ast.Name) else ""


def _is_plain(syntax: Syntax, node: ast.ClassDef) -> bool:
    known = all(isinstance(each, ast.Name) and _named(syntax, each.id) in _BASES for each in node.bases)
    return known and not node.keywords and not node.decorator_list


def _named(syntax: Syntax, name: str) -> str:
    return syntax.file.imports.get(name) or name


def _set(node: ast.ClassDef) -> dict[str, ast.Attribute]:
    """What methods set on ``self``, and the class does not have itself."""
    names = {name for each in own(node.body) for name in bound_names(each)}
    found: dict[str, ast.Attribute] = {}
    for each in walk(node):
        if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Store) and is_self(each.value):
            found.setdefault(each.attr, each)
    return {name: at for name, at in found.items() if name not in names}
