"""Divisions of a C++ file by a velocity of a command, which is 0 when the robot is to stop."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Divisor
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

DIVISORS = 100
"""Divisions of one file that are looked at."""
_DIVISOR = regex(rb"/\s{0,4}(?P<divisor>[A-Za-z_]\w{0,60}(?:->|\.)(?:twist\.)?(?:angular\.z|linear\.x))\b")
_MEASURED = regex(r"(?i)odom|state|pose|imu|measured|actual|current|feedback")
"""Names of what a sensor reports, which is hardly ever exactly 0."""
_GUARDS = regex(r"\bis_?(?:nan|finite|normal|inf)|fpclassify|near_?zero|is_?zero|epsilon|\beps\b", re.I)


def divisors(code: Code) -> Iterator[Divisor]:
    data = code.source.text.encode("utf-8", "surrogatepass")
    for found in islice(_DIVISOR.finditer(data), DIVISORS):
        node = code.tree.root_node.descendant_for_byte_range(*found.span("divisor"))
        outer = node.parent if node is not None else None
        if node is None or outer is None or outer.type != "binary_expression":
            continue
        operator, right = outer.child_by_field_name("operator"), outer.child_by_field_name("right")
        if code.text(operator) == "/" and right is not None and right.id == node.id:
            if not _MEASURED.search(code.text(node)) and not _is_guarded(code, node):
                span = code.span(node)
                is_zero = _is_zero_too(code, node, outer.child_by_field_name("left"))
                yield Divisor(code.source.located(span.start, span.end), is_zero)


def _is_zero_too(code: Code, divisor: Node, dividend: Node | None) -> bool:
    """Whether what is divided is the other velocity of the same message, perhaps multiplied: 0 to stop alone."""
    text = code.text(divisor)
    message = text.removesuffix("angular.z").removesuffix("linear.x")
    other = "linear.x" if text.endswith("angular.z") else "angular.z"
    return f"{message}{other}" in code.text(dividend).replace(" ", "").split("*")


def _is_guarded(code: Code, node: Node) -> bool:
    """Whether the function asks for the divisor anywhere, or for numbers that are none, or the file sets it."""
    function = next((each for each in code.above(node) if each.type == "function_definition"), None)
    text = code.text(function)
    name = re.escape(code.text(node))
    compared = rf"{name}\s{{0,4}}\)?\s{{0,4}}(?:[<>?]|[!=]=)|(?:[<>]|[!=]=)\s{{0,4}}(?:[\w:]{{1,40}}\()?{name}"
    asked = re.compile(rf"{compared}|!\s{{0,4}}{name}|if\s{{0,4}}\(\s{{0,4}}{name}\s{{0,4}}\)")
    is_set = re.compile(rf"{name}\s{{0,4}}=(?!=)")
    return function is None or bool(asked.search(text) or _GUARDS.search(text) or is_set.search(code.source.text))
