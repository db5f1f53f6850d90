"""Durations of a C++ file whose numbers have another unit or type than what takes them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import WrongDuration
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

MADE = ("Duration", "chrono::seconds")
_DURATION = regex(r"(?:rclcpp::)?Duration\Z")
_SECONDS = regex(r"(?:std::)?chrono::seconds\Z")
_FRACTION = regex(r"-?\d{0,9}\.\d{0,9}[1-9]\d{0,9}[fF]?\Z|\d{1,9}\.\d{0,9}[fF]?\s{0,4}/[^/]{1,200}\Z")
"""A number with a fraction, or a quotient that is one."""
_WHOLE = regex(r"(?P<number>[1-9]\d{0,18})[uUlL]*\Z")
_MILLI = regex(
    r"(?:1000[uUlL]*\s{0,4}\*\s{0,4})?\w{0,60}(?:[mM]illi[sS]ec\w{0,20}|[mM]illis|_ms|Ms|_msec)_?"
    r"(?:\s{0,4}\*\s{0,4}1000[uUlL]*)?\Z"
)
"""A name that says milliseconds, or a thousand times its value."""
_CAST = regex(
    r"(?:static_cast<\s{0,4}(?:u?int(?:\d+_t)?|long|unsigned)\s{0,4}>\s{0,4}\(|\(int\)\s{0,4}\(?)\s{0,4}(?:this->)?"
    r"(?P<name>\w+)\s{0,4}\)?\Z"
)
_DOUBLE = regex(r"\b(?:double|float)\s+(\w+)\b")
_MADE_OF = regex(r"(?:std::)?chrono::duration<double>[({](?:this->)?(?P<name>\w+)[)}]\Z")
_SMALL = range(2, 1_000_000)
"""Nanoseconds: nobody waits for less than a millisecond by hand. One is the least step of a time, and meant."""
_REST = regex(r"nanoseconds\b|\bfmod\b|\bmodf\b")
"""What takes the fraction that whole seconds leave."""


THROTTLED = "_THROTTLE"
_THROTTLE = regex(r"RCLCPP_[A-Z_]{1,40}_THROTTLE\Z")
_INSTANT = regex(r"(?:0?\.\d{1,9}|[1-9](?:\.\d{0,9})?)\Z")
"""Less than 10 milliseconds: nobody wants a hundred lines of a log a second, but 10 may thin out a loop of 1 kHz."""


def durations(code: Code) -> Iterator[WrongDuration]:
    """Those of ``rclcpp::Duration(seconds, nanoseconds)``, ``std::chrono::seconds`` of a number with a fraction, and
    those of logs that are throttled."""
    if THROTTLED in code.source.text:
        yield from _of_logs(code)
    if not any(each in code.source.text for each in MADE):
        return
    doubles = frozenset(_DOUBLE.findall(code.source.text))
    for call in code.calls:
        cast = _cast(code, call, doubles) if len(call.arguments) == 1 else None
        if cast is not None and not _REST.search(code.text(code.body_of(call.node))):
            yield WrongDuration(code.span(call.node), "cast", cast)
        elif len(call.arguments) == 2 and _DURATION.match(call.qualified) and "rclcpp" in code.source.text:
            yield from _of_pair(code, call.node, *map(code.text, call.arguments))
    for node in code.written.get("declaration", ()):
        declarator = node.child_by_field_name("declarator")
        value = declarator.child_by_field_name("value") if declarator is not None else None
        if value is None or value.type not in ("argument_list", "initializer_list") or value.named_child_count != 2:
            continue
        if "".join(code.text(node.child_by_field_name("type")).split()) == "rclcpp::Duration":
            yield from _of_pair(code, value, *(code.text(each) for each in value.named_children))


def _of_logs(code: Code) -> Iterator[WrongDuration]:
    """The periods of ``RCLCPP_INFO_THROTTLE(logger, clock, period, text)``."""
    for call in code.calls:
        if len(call.arguments) > 3 and _THROTTLE.match(call.name):
            period = code.text(call.arguments[2])
            if _INSTANT.match(period):
                yield WrongDuration(code.span(call.arguments[2]), "throttle", period)


def _cast(code: Code, call: Call, doubles: frozenset[str]) -> str | None:
    """The ``double`` of which whole seconds are made by a call with one argument."""
    if call.name == "duration_cast":
        is_whole = _SECONDS.match(code.text(call.template).strip("<> "))
        found = _MADE_OF.match("".join(code.text(call.arguments[0]).split())) if is_whole else None
        return found["name"] if found is not None else None
    found = _CAST.match(code.text(call.arguments[0])) if _SECONDS.match(call.qualified) else None
    return found["name"] if found is not None and found["name"] in doubles else None


def _of_pair(code: Code, node: Node, seconds: str, rest: str) -> Iterator[WrongDuration]:
    span = code.span(node)
    if _FRACTION.match(seconds):
        yield WrongDuration(span, "cut", seconds)
        return
    whole, milli = _WHOLE.match(rest), _MILLI.match(rest)
    if whole is not None and int(whole["number"]) in _SMALL:
        yield WrongDuration(span, "small", whole["number"])
    elif milli is not None:
        yield WrongDuration(span, "milli", rest)
