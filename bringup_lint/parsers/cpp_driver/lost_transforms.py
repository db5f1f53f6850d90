"""Transforms that a C++ file goes on with although there is none: what takes the exception only logs it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import LostTransform
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node

LOOKS_UP = regex(r"\b(?:lookupTransform|transform)\s{0,4}\(", hints="lookupTransform transform")
_TAKES = regex(r"\bcatch\s{0,4}\([^(){}]{0,80}\b(?:\w{0,40}Exception|exception|runtime_error)\b")
_MESSAGE = regex(r"geometry_msgs::(?:msg::)?\w+\Z")
_LOGS = regex(
    r"(?:RCLCPP|ROS)_(?:DEBUG|INFO|WARN|ERROR|FATAL)\w*\Z|(?:std::)?(?:printf|fprintf|perror)\Z|sleep(?:_for)?\Z"
)
_LEAVES = regex(r"\b(?:return|throw|break|continue|goto|\w{0,20}exit|abort|shutdown)\b")
_SET = regex(r"(?:\s{0,4}\.\s{0,4}\w+){0,8}\s{0,4}=(?!=)")
_PLAIN = ("expression_statement", "declaration")


def lost_transforms(code: Code) -> Iterator[LostTransform]:
    """One for each ``try`` that fills a message of the function, which is used behind it whatever happened."""
    if not _TAKES.search(code.source.text):
        return
    by_body: dict[int, list[Call]] = {}
    for call in code.calls:
        statement = _statement(call.node)
        if call.name in ("lookupTransform", "transform") and statement is not None and statement.parent is not None:
            by_body.setdefault(statement.parent.id, []).append(call)
    if not by_body:
        return
    for tried in code.written.get("try", ()):
        body = tried.child_by_field_name("body")
        calls = by_body.get(body.id, []) if body is not None else []
        handlers = [each for each in tried.named_children if each.type == "catch_clause"]
        if calls and all(_only_logs(code, each) for each in handlers):
            found = next((one for call in calls if (one := _lost(code, tried, call, handlers[0])) is not None), None)
            if found is not None:
                yield found


def _statement(node: Node) -> Node | None:
    """The expression statement that a call is, or whose value it gives."""
    outer = node.parent
    if outer is not None and outer.type == "assignment_expression":
        outer = outer.parent
    return outer if outer is not None and outer.type == "expression_statement" else None


def _only_logs(code: Code, handler: Node) -> bool:
    body = handler.child_by_field_name("body")
    statements = [each for each in body.named_children if each.type != "comment"] if body is not None else []
    calls = [code.call(each.named_children[0]) for each in statements if _is_call(each)]
    return len(calls) == len(statements) and all(each is not None and _LOGS.match(each.name) for each in calls)


def _is_call(statement: Node) -> bool:
    return (
        statement.type == "expression_statement"
        and statement.named_child_count > 0
        and statement.named_children[0].type == "call_expression"
    )


def _lost(code: Code, tried: Node, call: Call, handler: Node) -> LostTransform | None:
    name = _filled(code, call)
    declared = _declared(code, tried, name) if name is not None else None
    if name is None or declared is None:
        return None
    word = re.compile(rf"\b{re.escape(name)}\b")
    if word.search(blanked(code.source.text[code.span(declared).end : code.span(tried).start])):
        return None  # it may have a value already
    used = _used(code, tried, word)
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


def _used(code: Code, tried: Node, word: re.Pattern[str]) -> Span | None:
    """Where a statement behind the ``try`` uses the variable, when nothing before it may leave or set it."""
    following = tried.next_named_sibling
    while following is not None:
        text = blanked(code.text(following))
        found = word.search(text)
        body = following.child_by_field_name("body") if following.type == "try_statement" else None
        if found is not None and body is not None and body.named_child_count:
            following = body.named_children[0]
            continue
        if found is not None:
            if following.type not in _PLAIN or _SET.match(text, found.end()):
                return None
            start = code.span(following).start
            return code.source.span(start + found.start(), start + found.end())
        if _LEAVES.search(text):
            return None
        following = following.next_named_sibling
    return None
