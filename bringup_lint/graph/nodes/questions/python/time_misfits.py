"""Times and durations in Python nodes that are used as rospy's were, or as numbers."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.message_types import MessageTypes
from bringup_lint.graph.nodes.sources.parameter_types import read_type
from bringup_lint.graph.nodes.sources.what_ends import end_of
from bringup_lint.named_tuple import NamedTuple

TIME, SYSTEM_TIME, CLOCKED, DURATION = "Time of the node's clock", "Time of the system clock", "Time", "Duration"
"""``CLOCKED``: a Time of a clock that is not known."""
_TIMES = frozenset({TIME, SYSTEM_TIME, CLOCKED})
_MESSAGES = {"builtin_interfaces/msg/Time": "Time message", "builtin_interfaces/msg/Duration": "Duration message"}
_NUMBER = "number"
_NUMBERS = ("double", "integer")
"""Types of parameters."""
_MADE = {
    "rclpy.time.Time": SYSTEM_TIME,
    "rclpy.time.Time.from_msg": TIME,
    "rclpy.duration.Duration": DURATION,
    "rclpy.duration.Duration.from_msg": DURATION,
    "time.time": _NUMBER,
    "time.monotonic": _NUMBER,
    "time.perf_counter": _NUMBER,
    "float": _NUMBER,
}
_LACKING = frozenset({"to_sec", "to_nsec", "to_time", "is_zero", "secs", "nsecs", "sec", "nanosec"})
"""What rospy's times, or the messages, have, and those of rclpy of no release."""
_ORDERS = (ast.Lt, ast.LtE, ast.Gt, ast.GtE)
_CAUGHT = {error: frozenset({"Exception", "BaseException", error}) for error in ("AttributeError", "TypeError")}


class TimeMisfit(NamedTuple):
    place: ast.expr
    kinds: tuple[str, ...]
    """What is used, or what is subtracted, added or compared: ``Time of the node's clock``, ``number``."""
    attribute: str | None
    """What the only one has not; None: the two do not go together."""
    done: str
    """What raises, in words: ``subtracts a number from a Duration``."""
    end: str
    """What the exception ends, in words."""


def time_misfits(types: MessageTypes) -> Iterator[TimeMisfit]:
    kinds = _Kinds(types)
    for node in types.file.nodes:
        found = kinds.misfit(node)
        if found and isinstance(node, ast.expr) and not types.syntax.is_dead(node):
            attribute = node.attr if isinstance(node, ast.Attribute) else None
            caught = types.syntax.catches(node, _CAUGHT["TypeError" if attribute is None else "AttributeError"])
            end = end_of(types.syntax, node, caught=caught)
            yield TimeMisfit(node, found, attribute, _done(node, found), end)


def _done(node: ast.expr, kinds: tuple[str, ...]) -> str:
    if isinstance(node, ast.Compare):
        return f"compares a {kinds[0]} with a {kinds[1]}"
    if isinstance(node, ast.BinOp):
        adds = isinstance(node.op, ast.Add)
        return f"adds a {kinds[0]} and a {kinds[1]}" if adds else f"subtracts a {kinds[1]} from a {kinds[0]}"
    return f"takes a {kinds[0].partition(' ')[0]} of rclpy for one of rospy or a message"


_DEEPEST = 40
"""How many values lead to one another at most."""


class _Kinds:
    """What the expressions of one file are: times, durations, numbers."""

    def __init__(self, types: MessageTypes) -> None:
        self._types = types
        self._known: dict[ast.expr, str | None] = {}
        self._depth = 0

    def misfit(self, node: ast.AST) -> tuple[str, ...]:
        if isinstance(node, ast.Attribute) and node.attr in _LACKING:
            kind = self._of(node.value)
            return (kind,) if kind == DURATION or kind in _TIMES else ()
        if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Sub, ast.Add)):
            sides = node.left, node.right
        elif isinstance(node, ast.Compare) and len(node.ops) == 1 and isinstance(node.ops[0], _ORDERS):
            sides = node.left, node.comparators[0]
        else:
            return ()
        left, right = (self._of(each) for each in sides)
        if left is None or right is None or left == right == _NUMBER:
            return ()
        if isinstance(node, ast.Compare):
            fits = left == right == DURATION or _is_of_one_clock(left, right)
        else:
            fits = left == right == DURATION or _result(left, node.op, right) is not None
        return () if fits else (left, right)

    def _of(self, value: ast.expr) -> str | None:
        """What a value is; None when that is not known, or it has nothing to do with time."""
        if value not in self._known:
            if self._depth == _DEEPEST:
                return None
            self._known[value] = None
            self._depth += 1
            self._known[value] = self._found(value)
            self._depth -= 1
        return self._known[value]

    def _found(self, value: ast.expr) -> str | None:
        if isinstance(value, ast.Constant):
            return _NUMBER if type(value.value) in (int, float) else None
        if isinstance(value, ast.Call):
            if _asks_clock(value):
                return TIME
            made = _MADE.get(self._types.file.qualified(value.func) or "")
            return CLOCKED if made in _TIMES and _names_clock(value) else made
        if isinstance(value, ast.BinOp):
            left, right = self._of(value.left), self._of(value.right)
            if left == right == DURATION and isinstance(value.op, (ast.Add, ast.Sub)):
                return DURATION
            return _result(left, value.op, right)
        if read_type(self._types.syntax, value) in _NUMBERS:
            return _NUMBER
        bound = [each for each in self._types.values(value) if not _is_none(each)]
        kinds = {self._of(each) for each in bound}
        if len(kinds) == 1:
            return kinds.pop()
        return _MESSAGES.get(self._types.of(value) or "") if isinstance(value, (ast.Name, ast.Attribute)) else None


def _result(left: str | None, operator: ast.operator, right: str | None) -> str | None:
    """What a sum or difference with a time is."""
    if left in _TIMES and right == DURATION and isinstance(operator, (ast.Add, ast.Sub)):
        return left
    if left == DURATION and right in _TIMES and isinstance(operator, ast.Add):
        return right
    return DURATION if isinstance(operator, ast.Sub) and _is_of_one_clock(left, right) else None


def _is_of_one_clock(left: str | None, right: str | None) -> bool:
    """Whether two values are times that may be of the same clock."""
    return left in _TIMES and right in _TIMES and (left == right or CLOCKED in (left, right))


def _names_clock(call: ast.Call) -> bool:
    """Whether ``Time(...)`` or ``Time.from_msg(...)`` says of which clock the time is."""
    return len(call.args) > 1 or any(each.arg in (None, "clock_type") for each in call.keywords)


def _asks_clock(call: ast.Call) -> bool:
    """``….get_clock().now()``"""
    function = call.func
    if not isinstance(function, ast.Attribute) or function.attr != "now" or not isinstance(function.value, ast.Call):
        return False
    return isinstance(function.value.func, ast.Attribute) and function.value.func.attr == "get_clock"


def _is_none(value: ast.expr) -> bool:
    return isinstance(value, ast.Constant) and value.value is None
