"""Functions of a C++ file that may be handlers of signals, and wait for a lock."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import WaitingHandler
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

HANDLES = regex(
    r"void\s{1,4}(?:\w+::)*\w+\s{0,4}\(\s{0,4}(?:const\s{1,4})?int\b[^,(){};]{0,40}\)\s{0,40}\{", hints="void"
)
"""A function with the signature of a handler."""
_WAITS = regex(
    r"\b(?P<log>(?:RCLCPP|ROS)_(?:DEBUG|INFO|WARN|ERROR|FATAL)\w*)\s{0,4}\("
    r"|\b(?P<lock>(?:std::)?(?:lock_guard|unique_lock|scoped_lock)\b)|\.\s{0,4}(?P<locked>lock\s{0,4}\(\s{0,4}\))"
)
_STATIC = regex(r"(?:inline\s{1,4})?static\b")


def waiting_handlers(code: Code) -> Iterator[WaitingHandler]:
    """The functions with one whole number that log or lock; which of them a signal calls, other files may say."""
    for function in code.written.get("function", ()):
        body = function.child_by_field_name("body")
        if body is None or not _is_handler(code, function, body):
            continue
        span = code.span(body)
        found = _WAITS.search(blanked(code.text(body)))
        if found is not None:
            name = (code.defined_name(function) or "").rpartition("::")[2]
            start = span.start + found.start(str(found.lastgroup))
            place = code.source.located(start, span.start + found.end(str(found.lastgroup)))
            yield WaitingHandler(place, name, found["log"] is not None)


def _is_handler(code: Code, function: Node, body: Node) -> bool:
    head = code.text(function)[: code.offset(body.start_byte) - code.offset(function.start_byte) + 1]
    is_inside = any(each.type == "class_specifier" for each in code.above(function))
    return HANDLES.search(head) is not None and (not is_inside or _STATIC.match(head) is not None)
