"""Values that a publisher does not take: rclpy wants a message of the type with which the publisher was made."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.message_types import MessageTypes
from bringup_lint.graph.nodes.sources.message_types import message_type
from bringup_lint.graph.nodes.sources.what_ends import end_of
from bringup_lint.named_tuple import NamedTuple

_DEPTH = 4
_CAUGHT = frozenset({"Exception", "BaseException", "TypeError"})
_CALLS = {"int": "an int", "float": "a float", "str": "a str", "bool": "a bool", "len": "an int", "list": "a list"}
"""Functions of Python, each with what it returns."""
_DISPLAYS = {ast.JoinedStr: "a str", ast.Compare: "a bool", ast.List: "a list", ast.Dict: "a dict"}
_LITERALS = {int: "an int", float: "a float", str: "a str", bool: "a bool"}


class WrongPublish(NamedTuple):
    """A call of publish() with what is no message, or another one."""

    value: ast.expr
    made: ast.expr
    """The type that the publisher was made with."""
    wanted: str
    """``std_msgs/msg/Bool``."""
    got: str
    """In words: ``a bool``; or the type of the other message."""
    end: str
    """What the exception ends, in words."""


def wrong_publishes(types: MessageTypes) -> Iterator[WrongPublish]:
    for call in types.syntax.calls:
        if not isinstance(call.func, ast.Attribute) or call.func.attr != "publish" or len(call.args) != 1:
            continue
        value = call.args[0]
        made = _made_with(types, call.func.value)
        wanted = message_type(types.file.qualified(made)) if made is not None else None
        got = _kind(types, value, 0) or types.of(value) if wanted is not None else None
        if made is None or wanted is None or got in (None, wanted) or types.syntax.is_dead(value):
            continue
        end = end_of(types.syntax, value, caught=types.syntax.catches(value, _CAUGHT))
        yield WrongPublish(value, made, wanted, str(got), end)


def _made_with(types: MessageTypes, publisher: ast.expr) -> ast.expr | None:
    """The type that the only call gets which makes a publisher."""
    calls = types.values(publisher)
    call = calls[0] if len(calls) == 1 else None
    if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Attribute) or not call.args:
        return None
    return call.args[0] if call.func.attr == "create_publisher" else None


def _kind(types: MessageTypes, value: ast.expr, depth: int) -> str | None:
    """What a value is that surely is no message, in words."""
    if type(value) in _DISPLAYS:
        return _DISPLAYS[type(value)]
    if isinstance(value, ast.Constant):
        return _LITERALS.get(type(value.value))
    if isinstance(value, ast.UnaryOp) and isinstance(value.op, ast.Not):
        return "a bool"
    if isinstance(value, ast.Call):
        name = types.file.qualified(value.func)
        return "a str" if name == "json.dumps" else _CALLS.get(getattr(value.func, "id", ""))
    kinds = {_kind(types, each, depth + 1) for each in types.values(value)} if depth < _DEPTH else set()
    return kinds.pop() if len(kinds) == 1 else None
