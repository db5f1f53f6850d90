"""Which special methods of the plain classes of a tree its code runs by operators and builtin functions."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import kept
from bringup_lint.graph.nodes.questions.python.plain_attributes import PlainAttribute
from bringup_lint.graph.nodes.sources.object_classes import object_classes
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_FUNCTIONS = {"len": "__len__", "str": "__str__", "print": "__str__", "repr": "__repr__", "hash": "__hash__"}
_FUNCTIONS |= dict.fromkeys(("iter", "list", "tuple", "set", "sorted", "sum", "min", "max", "enumerate"), "__iter__")
_COMPARES: dict[type[ast.cmpop], str] = {ast.Eq: "__eq__", ast.NotEq: "__eq__", ast.Lt: "__lt__"}
_REPR = ord("r")


def is_operated(nodes: Nodes, found: PlainAttribute) -> bool:
    """Whether the tree does with an object of a class what runs the method that uses an attribute: ``len(queue)`` for
    ``__len__``."""
    return (found.file.source, found.owner, found.function) in _operated(nodes)


@kept
def _operated(nodes: Nodes) -> set[tuple[Source, str, str]]:
    """The files, classes and names of the methods."""
    found: set[tuple[Source, str, str]] = set()
    for file in nodes.robot_code:
        objects = object_classes(nodes, file)
        if not objects.any:
            continue
        for value, method in (pair for each in file.nodes for pair in _operations(each)):
            defined = objects.of(value)
            if defined is not None:
                found.add((defined.file.source, defined.node.name, method))
    return found


def _operations(node: ast.AST) -> Iterator[tuple[ast.expr, str]]:
    """The operands of an expression, each with the method that it runs."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in _FUNCTIONS:
        yield from ((each, _FUNCTIONS[node.func.id]) for each in node.args)
    elif isinstance(node, ast.FormattedValue):
        yield node.value, "__repr__" if node.conversion == _REPR else "__str__"
    elif isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Load):
        yield node.value, "__getitem__"
    elif isinstance(node, (ast.For, ast.comprehension)):
        yield node.iter, "__iter__"
    elif isinstance(node, ast.Compare):
        for operator, right in zip(node.ops, node.comparators):
            if isinstance(operator, (ast.In, ast.NotIn)):
                yield right, "__contains__"
            elif type(operator) in _COMPARES:
                yield node.left, _COMPARES[type(operator)]
