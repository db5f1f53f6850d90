"""Percentages of a battery in C++ nodes, where a share of 1 is meant."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.nodes.questions.messages.wrong_unit import PERCENT
from bringup_lint.graph.nodes.questions.messages.wrong_unit import TELLS_APART
from bringup_lint.graph.nodes.questions.messages.wrong_unit import WrongUnit
from bringup_lint.model.cpp_text import blanked
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

_BATTERY = "sensor_msgs/msg/BatteryState"
_BATTERIES = frozenset({"BatteryState", "msg::BatteryState", "sensor_msgs::msg::BatteryState"})
_UNKNOWN = frozenset({"?"})
_FIELD = regex(
    r"\b(?P<message>\w+)(?:->|\.)percentage\s{0,4}(?:[<>]=?|(?P<set>=)(?!=))\s{0,4}"
    r"(?P<number>\d{1,3}(?:\.\d*)?)f?\s{0,4}(?=[;)&|])"
)
_TIMES = regex(r"\b(?P<message>\w+)(?:->|\.)percentage\s{0,4}=[^;=\n]{1,200}\*\s{0,4}100(?:\.0*)?f?\s{0,4};")
"""A value that is made a percentage at last."""
_DECLARED = regex(r"(?<![\w:])(?P<type>\w[\w:]{0,120}?)(?:::\w{0,20}Ptr)?[ \t>&*]{1,4}(?=(?P<name>\w+)\s{0,4}[;,)({=])")


def in_cpp(source: Source) -> Iterator[WrongUnit]:
    """What a source compares with the share of a battery, and what it makes of it."""
    text = source.text
    if "sensor_msgs/msg/battery_state" not in text or "percentage" not in text:
        return
    plain = blanked(text)
    types = _declared(plain)
    for found in _FIELD.finditer(plain):
        if PERCENT <= float(found["number"]) <= 100 and types.get(found["message"], _UNKNOWN) <= _BATTERIES:
            is_read = found["set"] is None
            if not is_read or not TELLS_APART.search(plain):
                yield WrongUnit(Span(source, *found.span()), _BATTERY, "percentage", is_read, found["number"])
    for found in _TIMES.finditer(plain):
        if types.get(found["message"], _UNKNOWN) <= _BATTERIES:
            yield WrongUnit(Span(source, found.start(), found.end() - 1), _BATTERY, "percentage", False, "")


def _declared(text: str) -> dict[str, set[str]]:
    """Variable or member -> the types that it is declared with anywhere in a source."""
    found: dict[str, set[str]] = {}
    for each in _DECLARED.finditer(text):
        if each["type"] not in ("return", "else"):
            found.setdefault(each["name"], set()).add(each["type"])
    return found
