"""Transforms that a C++ file goes on with although there is none: what takes the exception only logs it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import LostTransform
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.parsers.cpp_driver.only_logged import LEAVES
from bringup_lint.parsers.cpp_driver.only_logged import behind
from bringup_lint.parsers.cpp_driver.only_logged import only_log
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

LOOKS_UP = regex(r"(?:\.|->)\s{0,4}(?:lookupTransform|transform)\s{0,4}\(", hints="lookupTransform transform")
TAKES = regex(r"\bcatch\s{0,4}\([^(){}]{0,80}\b(?:\w{0,40}Exception|exception|runtime_error)\b")
MOST = 50
"""Calls of one file that are looked at."""
_MESSAGE = regex(r"geometry_msgs::(?:msg::)?\w+\Z")
_STOPS = LEAVES + r"|\b{0}(?:\s{{0,4}}\.\s{{0,4}}\w+){{0,8}}\s{{0,4}}=(?!=)"
"""What leaves the function, or sets the variable or a part of it."""


def lost_transforms(code: Code) -> Iterator[LostTransform]:
    """One for each ``try`` that fills a message of the function, which is used behind it whatever happened."""
    by_body: dict[int, list[Call]] = {}
    for call in islice((each for each in code.calls if each.name in ("lookupTransform", "transform")), MOST):
        statement = _statement(call.node)
        if statement is not None and statement.parent is not None:
            by_body.setdefault(statement.parent.id, []).append(call)
    if not by_body:
        return
    for tried in code.written.get("try", ()):
        body = tried.child_by_field_name("body")
        calls = by_body.get(body.id, []) if body is not None else []
        handler = only_log(code, tried) if calls else None
        if handler is not None:
            found = next((one for call in calls if (one := _lost(code, tried, call, handler)) is not None), None)
            if found is not None:
                yield found


def _statement(node: Node) -> Node | None:
    """The expression statement that a call is, or whose value it gives."""
    outer = node.parent
    if outer is not None and outer.type == "assignment_expression":
        outer = outer.parent
    return outer if outer is not None and outer.type == "expression_statement" else None


def _lost(code: Code, tried: Node, call: Call, handler: Node) -> LostTransform | None:
    name = _filled(code, call)
    declared = _declared(code, tried, name) if name is not None else None
    if name is None or declared is None:
        return None
    word = re.compile(rf"\b{re.escape(name)}\b")
    if word.search(plain_of(code.source), code.span(declared).end, code.span(tried).start):
        return None  # it may have a value already
    used = behind(code, tried, word, re.compile(_STOPS.format(re.escape(name))))
    return LostTransform(code.span(call.node), code.span(handler), used, name) if used is not None else None


def _filled(code: Code, call: Call) -> str | None:
    """The variable that gets the transform: ``name = ...``, or the second argument of ``transform``."""
    outer = call.node.parent
    if outer is not None and outer.type == "assignment_expression":
        left = outer.child_by_field_name("left")
    else:
        left = call.arguments[1] if call.name == "transform" and len(call.arguments) > 1 else None
    return code.text(left) if left is not None and left.type == "identifier" else None


def _declared(code: Code, tried: Node, name: str) -> Node | None:
    """The one declaration of a message without a value in the function of a ``try``, before it."""
    function = code.body_of(tried)
    if function is None:
        return None
    found = [
        each
        for each in code.written.get("declaration", ())
        if function.start_byte < each.start_byte < tried.start_byte
        and any(code.text(one) == name for one in each.children_by_field_name("declarator"))
    ]
    if len(found) != 1 or any(each.type == "storage_class_specifier" for each in found[0].children):
        return None
    kind = "".join(code.text(found[0].child_by_field_name("type")).split())
    return found[0] if _MESSAGE.match(kind) else None
