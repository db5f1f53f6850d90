"""What Python nodes take from the module rclpy, and it does not have."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.facts import table
from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.what_ends import end_of
from bringup_lint.model.python import PlacedNode
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

_ANNOTATIONS = ("annotation", "returns")
_CAUGHT = frozenset({"AttributeError", "ImportError", "Exception", "BaseException"})


class NoName(NamedTuple):
    place: PlacedNode
    name: str
    instead: str
    end: str
    """What the exception ends, in words."""
    idle: bool
    """Nothing runs the function around it."""

    @property
    def error(self) -> str:
        return "AttributeError" if isinstance(self.place, ast.Attribute) else "ImportError"


def lacking_names(syntax: Syntax) -> Iterator[NoName]:
    lacks = {row["name"]: row["instead"] for row in table("ros/rclpy_lacks")}
    lazy = any(dotted == "__future__.annotations" for dotted in syntax.file.imports.values())
    for node in syntax.file.nodes:
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.attr in lacks:
            taken = [node.attr] if syntax.file.qualified(node) == f"rclpy.{node.attr}" else []
        elif isinstance(node, ast.ImportFrom) and node.module == "rclpy":
            taken = [each.name for each in node.names if each.name in lacks]
        else:
            continue
        if taken and _is_run(syntax, node, lazy):
            idle = isinstance(node, ast.Attribute) and is_idle(syntax, node)
            yield from (NoName(node, name, lacks[name], end_of(syntax, node), idle) for name in taken)


def _is_run(syntax: Syntax, node: ast.AST, lazy: bool) -> bool:
    """Whether a statement or expression is evaluated, and nothing expects that it fails."""
    if syntax.is_dead(node) or syntax.catches(node, _CAUGHT):
        return False
    for outer, field in syntax.above(node):
        if field in _ANNOTATIONS and (lazy or (isinstance(outer, ast.AnnAssign) and syntax.function(node) is not None)):
            return False
        if isinstance(outer, ast.If) and "TYPE_CHECKING" in written(outer.test):
            return False
    return True
