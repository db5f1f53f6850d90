"""Fields of messages that do not exist, and values that they do not take."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from collections.abc import Mapping

from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.message_types import MessageTypes
from bringup_lint.graph.nodes.sources.message_types import message_type
from bringup_lint.graph.nodes.sources.message_types import sections_of
from bringup_lint.graph.nodes.sources.parameter_types import read_type
from bringup_lint.graph.nodes.sources.what_ends import end_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.interface import CONSTANT
from bringup_lint.pattern import regex

_OF_EVERY_MESSAGE = frozenset({"get_fields_and_field_types", "SLOT_TYPES"})
_CALLS = {"int": "int", "float": "float", "str": "str", "bool": "bool", "len": "int"}
"""Functions of Python, each with the type that it returns."""
_QUALIFIED = {f"time.{name}": "float" for name in ("time", "monotonic", "perf_counter")}
_OF_PARAMETERS = {"double": "float", "integer": "int", "bool": "bool", "string": "str"}
_WORDS = {"int": "an int", "float": "a float", "str": "a str", "bool": "a bool"}
_NUMBERS = frozenset({"int", "float"})
_WANTED = regex(r"(?P<float>float(?:32|64))$|(?P<bool>bool)$|(?P<str>w?string)$|(?P<int>u?int(?:8|16|32|64))$")
"""Types of fields, each in a group that is called as the type of Python which it takes."""
_TIMES = {"builtin_interfaces/Time": "rclpy.time.Time", "builtin_interfaces/Duration": "rclpy.duration.Duration"}
"""Messages that have no field for the object of rclpy which means the same."""
_OF_RCLPY = frozenset(f"an {each}" for each in _TIMES.values())
_CONSTANT, _FIELD = "constant", "field"
OUT_OF_RANGE = "out of its range"
_EXPECTED = frozenset({"TypeError"})
_CAUGHT = frozenset({"Exception", "BaseException", "AttributeError", "AssertionError", "TypeError"})


_CHECKING = ("foxy", "galactic", "humble")
"""Distributions whose messages look at the types of values (rosidl_python, _msg.py.em)."""
_UNCHECKED = {
    "float": "what is published carries 0, or the node aborts",
    "bool": "what is published carries False, or the node aborts",
    "str": "publish() raises TypeError",
    "int": "publish() raises SystemError",
}
"""What later ones make of a value of a wrong type, by what the field wants; tried with rclpy of Jazzy."""


class NoField(NamedTuple):
    """A field that is read or set, or given to the constructor, of a message that has none of this name."""

    place: ast.Attribute | ast.keyword
    name: str
    type: str
    fields: tuple[str, ...]
    given: bool
    """It is an argument of the constructor."""
    end: str
    """What the exception ends, in words."""

    @property
    def kind(self) -> str:
        """``constant`` for a name that is written as one."""
        return _CONSTANT if self.name.isupper() else _FIELD

    @property
    def others(self) -> list[str]:
        """The names of the same kind that the message has."""
        return sorted(each for each in self.fields if each.isupper() == self.name.isupper())


class WrongField(NamedTuple):
    """A value of another type than the field has."""

    value: ast.expr
    name: str
    wanted: str
    """The type of the field: ``float64``."""
    got: str
    """The type of the value in words: ``an int``; or that it is out of range."""
    end: str

    @property
    def kind(self) -> str:
        """What the field wants, with its article: ``an int32``."""
        return f"{'an' if self.wanted.startswith('int') else 'a'} {self.wanted}"


class Misplaced(NamedTuple):
    """``SetMode.MANUAL``, which is ``SetMode.Request.MANUAL``."""

    place: ast.Attribute
    part: str
    """``Request``"""
    end: str


class Unnamed(NamedTuple):
    """``Point(0.0, 0.0, 0.0)``"""

    calls: list[ast.Call]
    type: str
    end: str
    function: str
    """The function that no other of the file calls and that holds all of them; empty where there is none."""


def missing_fields(types: MessageTypes) -> Iterator[list[NoField]]:
    """The uses of fields that do not exist, those of one field of one type that end the same together, and all such
    uses of constants of a type."""
    groups: dict[tuple[str, str, bool, str], list[NoField]] = {}
    for each in sorted(_missing(types), key=lambda found: types.file.span_of(found.place).start):
        name = each.name if each.kind == _FIELD else _CONSTANT
        groups.setdefault((each.type, name, each.given, each.end), []).append(each)
    yield from groups.values()


def _missing(types: MessageTypes) -> Iterator[NoField]:
    for node in types.file.nodes:
        if isinstance(node, ast.Attribute):
            yield from _lacking(types, types.of(node.value) or _named(types, node), node.attr, node)
        elif isinstance(node, ast.Call):
            for each in node.keywords:
                yield from _lacking(types, types.made(node), each.arg, each)


def _named(types: MessageTypes, node: ast.Attribute) -> str | None:
    """The class of messages of which a constant is taken: ``BatteryState.TECHNOLOGY``."""
    return message_type(types.file.qualified(node.value)) if node.attr.isupper() else None


def misplaced_constants(types: MessageTypes) -> Iterator[Misplaced]:
    """Constants that are taken from a service or an action, and belong to one of its parts."""
    for node in types.file.nodes:
        if isinstance(node, ast.Attribute) and node.attr.isupper() and not types.syntax.is_dead(node):
            parts = sections_of(types.file.qualified(node.value))
            found = [each for each in parts if node.attr in (types.interfaces.fields(each) or {})]
            if found:
                yield Misplaced(node, found[0].rpartition("_")[2], _end(types, node))


def _lacking(
    types: MessageTypes, owner: str | None, name: str | None, place: ast.Attribute | ast.keyword
) -> Iterator[NoField]:
    fields = types.interfaces.fields(owner) if owner is not None else None
    if owner is None or fields is None or name is None or _has(fields, name) or types.syntax.is_dead(place):
        return
    yield NoField(place, name, owner, tuple(fields), isinstance(place, ast.keyword), _end(types, place))


def given_in_order(types: MessageTypes) -> Iterator[Unnamed]:
    """The messages that get their fields without the names, those of one type together."""
    groups: dict[tuple[str, str], list[ast.Call]] = {}
    for call in types.syntax.calls:
        made = types.made(call) if call.args and not isinstance(call.args[0], ast.Starred) else None
        if made is not None and not types.syntax.is_dead(call) and not types.syntax.catches(call, _EXPECTED):
            groups.setdefault((made, _end(types, call)), []).append(call)
    for (made, end), calls in groups.items():
        functions = [types.syntax.function(call) for call in calls]
        first = functions[0]
        idle = all(each is first for each in functions) and all(is_idle(types.syntax, call) for call in calls)
        yield Unnamed(calls, made, end, first.name if first is not None and idle else "")


def wrong_fields(types: MessageTypes, distribution: str | None) -> Iterator[list[WrongField]]:
    """The values that do not fit, those of one function, field type and value type that end the same together."""
    groups: dict[tuple[ast.AST | None, str, str, str], list[WrongField]] = {}
    for each in _wrong_fields(types):
        is_zero = each.wanted.startswith(("float", "bool")) and _literal(types, each.value) == 0
        if distribution in (None, *_CHECKING) or not is_zero:
            function = types.syntax.function(each.value)
            groups.setdefault((function, each.wanted, each.got, each.end), []).append(each)
    yield from groups.values()


def _wrong_fields(types: MessageTypes) -> Iterator[WrongField]:
    placed = (each for each in types.file.nodes if isinstance(each, (ast.Assign, ast.Call)))
    for node in sorted(placed, key=lambda each: (each.lineno, each.col_offset)):
        if isinstance(node, ast.Assign):
            for target in node.targets:
                if isinstance(target, ast.Attribute):
                    yield from _of_wrong_type(types, types.of(target.value), target.attr, node.value)
        elif isinstance(node, ast.Call):
            made = types.made(node)
            for each in node.keywords:
                if each.arg is not None:
                    yield from _of_wrong_type(types, made, each.arg, each.value)


def consequence(wrong: WrongField, distribution: str | None) -> str:
    """What happens when the value is set, in words."""
    match = _WANTED.match(wrong.wanted)
    later = _UNCHECKED[match.lastgroup or ""] if match is not None else "publish() raises AttributeError"
    if wrong.got == OUT_OF_RANGE:
        later = "another number is sent"
    if distribution in _CHECKING:
        return f"AssertionError, and {wrong.end}"
    return (
        later if distribution is not None else f"in Humble AssertionError, and {wrong.end}; in newer releases {later}"
    )


def is_checked(distribution: str | None) -> bool:
    """Whether the assignment itself may raise; else only what is published goes wrong."""
    return distribution is None or distribution in _CHECKING


def converted(wrong: WrongField, text: str) -> str | None:
    """The value as the field wants it; None when that is not plain."""
    if wrong.got in _OF_RCLPY:
        return f"{text}.to_msg()"
    if wrong.wanted.startswith("float") and wrong.got == _WORDS["int"] and text.lstrip("-").isdigit():
        return f"{text}.0"
    return None


def _has(fields: Mapping[str, str], name: str) -> bool:
    return name in fields or name in _OF_EVERY_MESSAGE or name.startswith("_")


def _of_wrong_type(types: MessageTypes, owner: str | None, name: str, value: ast.expr) -> Iterator[WrongField]:
    fields = types.interfaces.fields(owner) if owner is not None else None
    wanted = (fields or {}).get(name, "")
    if not wanted or wanted in (CONSTANT, "?") or types.syntax.is_dead(value):
        return
    for arm in _arms(value):
        got = _wrong(types, wanted, arm)
        if got is not None:
            yield WrongField(arm, name, wanted, _WORDS.get(got, got), _end(types, value))
            return


def _end(types: MessageTypes, node: ast.AST) -> str:
    return end_of(types.syntax, node, caught=types.syntax.catches(node, _CAUGHT))


def _arms(value: ast.expr) -> Iterator[ast.expr]:
    """What an expression may give: both values of a conditional one."""
    if isinstance(value, ast.IfExp):
        yield from _arms(value.body)
        yield from _arms(value.orelse)
    else:
        yield value


def _wrong(types: MessageTypes, wanted: str, value: ast.expr) -> str | None:
    """The type of a value that a field does not take; None when it does, or that is not known."""
    if wanted in _TIMES:
        return _wrong_time(types, _TIMES[wanted], value)
    match = _WANTED.match(wanted)
    got = _type_of(types, value) if match is not None else None
    if match is None or got is None:
        return None
    if match["int"]:
        if got == "bool":
            return None
        return got if got != "int" else _out_of_range(types, value, wanted)
    return got if got != (match.lastgroup or "") else None


def _wrong_time(types: MessageTypes, similar: str, value: ast.expr) -> str | None:
    """As ``_wrong``, of a field for a time or duration, which takes neither numbers nor what rclpy has for it."""
    made = types.file.qualified(value.func) if isinstance(value, ast.Call) else None
    if made == similar or (similar.endswith("Time") and _is_clock(value)):
        return f"an {similar}"
    kind = _type_of(types, value)
    return kind if kind in _NUMBERS else None


def _out_of_range(types: MessageTypes, value: ast.expr, wanted: str) -> str | None:
    number = _literal(types, value)
    if not isinstance(number, int):
        return None
    bits = int(wanted.lstrip("uint"))
    low, high = (0, 2**bits) if wanted.startswith("u") else (-(2 ** (bits - 1)), 2 ** (bits - 1))
    return None if low <= number < high else OUT_OF_RANGE


def _is_clock(value: ast.expr) -> bool:
    """``….get_clock().now()``, without ``to_msg()``."""
    function = value.func if isinstance(value, ast.Call) else None
    if not isinstance(function, ast.Attribute) or function.attr != "now" or not isinstance(function.value, ast.Call):
        return False
    return isinstance(function.value.func, ast.Attribute) and function.value.func.attr == "get_clock"


def _literal(types: MessageTypes, value: ast.expr) -> object:
    if isinstance(value, ast.UnaryOp) and isinstance(value.op, (ast.USub, ast.UAdd)):
        number = _literal(types, value.operand)
        if isinstance(number, (int, float)):
            return -number if isinstance(value.op, ast.USub) else number
        return None
    if isinstance(value, ast.Constant):
        return value.value
    return types.file.constant(value, types.syntax.function(value))


def _type_of(types: MessageTypes, value: ast.expr) -> str | None:
    """``int``, ``float``, ``str`` or ``bool``; None when it is not known."""
    if isinstance(value, ast.JoinedStr):
        return "str"
    if isinstance(value, ast.Compare):
        return "bool" if all(isinstance(each, (ast.Is, ast.IsNot, ast.In, ast.NotIn)) for each in value.ops) else None
    if isinstance(value, ast.UnaryOp) and isinstance(value.op, ast.Not):
        return "bool"
    if isinstance(value, ast.BinOp):
        return _of_operation(types, value)
    if isinstance(value, ast.Call):
        return _of_call(types, value)
    if isinstance(value, ast.Attribute) and value.attr == "nanoseconds" and _is_clock(value.value):
        return "int"
    literal = _literal(types, value)
    return type(literal).__name__ if type(literal) in (int, float, str, bool) else _of_parameter(types, value)


def _of_call(types: MessageTypes, call: ast.Call) -> str | None:
    name = call.func.id if isinstance(call.func, ast.Name) else ""
    if name in _CALLS:
        return _CALLS[name] if name not in types.file.functions and name not in types.file.imports else None
    return _QUALIFIED.get(types.file.qualified(call.func) or "")


def _of_parameter(types: MessageTypes, value: ast.expr) -> str | None:
    """The type of the parameter that is read here, or whose value a name has."""
    reads = types.values(value) or [value]
    kinds = {read_type(types.syntax, each) for each in reads}
    return _OF_PARAMETERS.get(kinds.pop() or "") if len(kinds) == 1 else None


def _of_operation(types: MessageTypes, value: ast.BinOp) -> str | None:
    sides = [_type_of(types, value.left), _type_of(types, value.right)]
    if not _NUMBERS.issuperset(sides):
        return None
    if isinstance(value.op, ast.Div):
        return "float"
    if isinstance(value.op, (ast.Add, ast.Sub, ast.Mult)):
        return "float" if "float" in sides else "int"
    return None
