"""The handlers of ``main`` after which a failed node ends as if all had gone well."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Swallowed
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

_FAILS = regex(
    r"\b(?:quick_)?_?_?[eE]xit\w{0,20}\s{0,4}\(|\b(?:abort|terminate|raise|kill|exec\w{1,4})\s{0,4}\(|\bEXIT_FAILURE\b"
)
"""What may end a program with another status, anywhere in its source."""
_GOES_ON = regex(r"\b(?:throw|return|goto)\b|[^=!<>]=(?!=)|\+\+|--")
"""What a handler does that only reports."""
_TAKES_MUCH = regex(r"\.\.\.|\b(?:exception|runtime_error)\b")
_RETURNS = regex(r"\breturn\b([^;]{0,80});")
_LOOPS = frozenset({"for_statement", "for_range_loop", "while_statement", "do_statement", "lambda_expression"})


def swallowed(code: Code) -> Iterator[Swallowed]:
    """Those of a ``try`` around a spin, where ``main`` returns 0 in each case."""
    text = code.source.text
    if "catch" not in text or _FAILS.search(blanked(text)):
        return
    for call in code.calls:
        attempt = _attempt(code, call.node) if call.name == "spin" else None
        if attempt is None:
            continue
        for each in attempt.named_children:
            if each.type == "catch_clause" and _is_quiet(code, each):
                place = code.span(each.child_by_field_name("parameters") or each)
                yield Swallowed(place, code.span(call.node))


def _attempt(code: Code, spin: Node) -> Node | None:
    """The ``try`` that takes what a spin of ``main`` throws, when no loop tries again and ``main`` returns only 0."""
    attempt = None
    for outer in code.above(spin):
        if outer.type in _LOOPS:
            return None
        if outer.type == "try_statement":
            attempt = attempt or outer
        if outer.type == "function_definition":
            is_main = code.defined_name(outer) == "main"
            return attempt if is_main and _returns_zero(blanked(code.text(outer))) else None
    return None


def _returns_zero(main: str) -> bool:
    return all(found[1].strip() in ("0", "EXIT_SUCCESS") for found in _RETURNS.finditer(main))


def _is_quiet(code: Code, handler: Node) -> bool:
    taken = code.text(handler.child_by_field_name("parameters"))
    body = blanked(code.text(handler.child_by_field_name("body")))
    return bool(_TAKES_MUCH.search(taken)) and not _GOES_ON.search(body)
