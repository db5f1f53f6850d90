"""What a C++ file throws that is no exception."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import Thrown
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

THROWS = regex(r"\bthrow\s{1,4}(?:errno|[\"\d-]|(?:std::)?(?:strerror|string|to_string)\s{0,4}\()", hints="throw")
_TEXT = regex(r"(?:std::)?(?:strerror|string|to_string)\s{0,4}\(")
_LITERALS = {"string_literal": "a text", "concatenated_string": "a text", "number_literal": "a number"}


def thrown(code: Code) -> Iterator[Thrown]:
    """The places outside every ``try`` of their function."""
    for node in code.written.get("throw", ()):
        kind = _kind(code, node.named_children[0]) if node.named_child_count else None
        if kind is not None and not _is_tried(code, node):
            yield Thrown(code.span(node), kind)


def _kind(code: Code, value: Node) -> str | None:
    if value.type in _LITERALS:
        return _LITERALS[value.type]
    text = code.text(value)
    if text == "errno":
        return "a number"
    return "a text" if value.type == "call_expression" and _TEXT.match(text) else None


def _is_tried(code: Code, node: Node) -> bool:
    for outer in code.above(node):
        if outer.type == "try_statement":
            return True
        if outer.type == "function_definition":
            return code.defined_name(outer) == "main"
    return False
