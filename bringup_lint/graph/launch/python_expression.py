"""The small part of Python that ``PythonExpression`` is used for, evaluated on literals without running anything."""

from __future__ import annotations

import ast
import builtins
import math
import operator
import warnings
from collections.abc import Callable
from typing import Any

LENGTH = 2_000
_COMPARE = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.In: lambda item, group: item in group,
    ast.NotIn: lambda item, group: item not in group,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
}
_ARITHMETIC = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv}
_METHODS: dict[str, Callable[[str], str]] = {"lower": str.lower, "upper": str.upper, "strip": str.strip}
_TESTS: dict[str, Callable[[str, Any], bool]] = {"startswith": str.startswith, "endswith": str.endswith}
_KINDS: dict[str, Callable[[Any], Any]] = {"str": str, "int": int, "float": float, "bool": bool, "len": len}


_NAMES = frozenset((*dir(builtins), *dir(math), "math"))
"""What an expression may name without modules of its own. Source: launch, python_expression.py."""


class NotEvaluated(Exception):
    """The expression is not one of those that are understood, or would raise."""


class UndefinedName(NotEvaluated):
    """The expression asks for a name that nothing defines."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.name = name


def failure(text: str) -> str | None:
    """What Python certainly says of an expression that it cannot evaluate."""
    if not text.strip() or len(text) > LENGTH:
        return None
    try:
        evaluate(text)
    except UndefinedName as error:
        return f"name '{error.name}' is not defined"
    except NotEvaluated as error:
        return "invalid syntax" if isinstance(error.__cause__, SyntaxError) else None
    return None


def evaluate(text: str) -> Any:
    """The value of an expression of constants. Raises NotEvaluated."""
    if len(text) > LENGTH:
        raise NotEvaluated
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return _value(ast.parse(text.strip(), mode="eval").body)
    except (SyntaxError, ValueError, TypeError, ArithmeticError, RecursionError, MemoryError, KeyError) as error:
        raise NotEvaluated from error


def _value(node: ast.expr) -> Any:
    if isinstance(node, ast.Constant):
        return node.value
    if isinstance(node, ast.Name) and node.id not in _NAMES:
        raise UndefinedName(node.id)
    if isinstance(node, ast.BoolOp):
        return _bool(node)
    if isinstance(node, ast.UnaryOp):
        operand = _value(node.operand)
        return (
            (not operand) if isinstance(node.op, ast.Not) else (-operand if isinstance(node.op, ast.USub) else +operand)
        )
    if isinstance(node, ast.Compare):
        left = _value(node.left)
        for op, right_node in zip(node.ops, node.comparators):
            right = _value(right_node)
            if not _COMPARE[type(op)](left, right):
                return False
            left = right
        return True
    if isinstance(node, ast.IfExp):
        return _value(node.body if _value(node.test) else node.orelse)
    if isinstance(node, (ast.Tuple, ast.List, ast.Set)):
        return tuple(_value(element) for element in node.elts)
    if isinstance(node, ast.BinOp):
        left, right = _value(node.left), _value(node.right)
        if isinstance(node.op, ast.Mult) and not (isinstance(left, (int, float)) and isinstance(right, (int, float))):
            raise NotEvaluated
        return _ARITHMETIC[type(node.op)](left, right)
    if isinstance(node, ast.Call):
        return _call(node)
    raise NotEvaluated


def _bool(node: ast.BoolOp) -> Any:
    value: Any = None
    for operand in node.values:
        value = _value(operand)
        if bool(value) is isinstance(node.op, ast.Or):
            break
    return value


def _call(node: ast.Call) -> Any:
    if node.keywords:
        raise NotEvaluated
    arguments = [_value(argument) for argument in node.args]
    if isinstance(node.func, ast.Name) and node.func.id in _KINDS and len(arguments) == 1:
        return _KINDS[node.func.id](arguments[0])
    if isinstance(node.func, ast.Attribute):
        owner = _value(node.func.value)
        if isinstance(owner, str) and not arguments and node.func.attr in _METHODS:
            return _METHODS[node.func.attr](owner)
        if isinstance(owner, str) and len(arguments) == 1 and node.func.attr in _TESTS:
            return _TESTS[node.func.attr](owner, arguments[0])
    raise NotEvaluated
