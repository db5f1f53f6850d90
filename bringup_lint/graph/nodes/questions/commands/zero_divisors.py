"""Divisions of Python nodes by a velocity of a command, which is 0 when the robot is to stop."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_VELOCITY = regex(r"\A[\w.]{1,100}\.(?:angular\.z|linear\.x)\Z")
_MEASURED = regex(r"(?i)odom|state|pose|imu|measured|actual|current|feedback|twist\.twist")
"""Names of what a sensor reports, which is hardly ever exactly 0."""
_CAUGHT = frozenset({"ZeroDivisionError", "ArithmeticError", "Exception", "BaseException"})
_CONDITIONS = (ast.If, ast.IfExp, ast.While, ast.Assert, ast.Compare, ast.BoolOp, ast.Match)


class ZeroDivisor(NamedTuple):
    file: NodeSource
    divisor: ast.expr
    name: str


def zero_divisors(nodes: Nodes) -> Iterator[ZeroDivisor]:
    for file in nodes.robot_sources:
        if "angular.z" in file.source.text or "linear.x" in file.source.text:
            syntax = nodes.syntax(file)
            for node in file.nodes:
                if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Div, ast.FloorDiv)):
                    name = written(node.right) if isinstance(node.right, ast.Attribute) else ""
                    if _VELOCITY.match(name) and not _MEASURED.search(name) and not _is_guarded(syntax, node, name):
                        yield ZeroDivisor(file, node.right, name)


def _is_guarded(syntax: Syntax, node: ast.BinOp, name: str) -> bool:
    """Whether the function asks for the divisor anywhere, takes the exception, or makes the command itself."""
    function = syntax.function(node)
    if function is None or syntax.catches(node, _CAUGHT) or syntax.is_dead(node):
        return True
    if name in syntax.once(_set) or name.partition(".")[0] not in {"self", *(each.arg for each in function.args.args)}:
        return True
    return name in syntax.once(_Conditions).of(function)


class _Conditions:
    """What the functions of one file ask for, each read once."""

    def __init__(self, syntax: Syntax) -> None:
        self._texts: dict[ast.AST, str] = {}

    def of(self, function: ast.AST) -> str:
        if function not in self._texts:
            asked = (each for each in walk(function) if isinstance(each, _CONDITIONS))
            self._texts[function] = "\n".join(map(written, asked))
        return self._texts[function]


def _set(syntax: Syntax) -> frozenset[str]:
    """The fields that the file sets."""
    attributes = (each for each in syntax.file.nodes if isinstance(each, ast.Attribute))
    return frozenset(written(each) for each in attributes if not isinstance(each.ctx, ast.Load))
