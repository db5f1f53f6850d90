"""Failures that a handler of a C++ file only logs, and what goes on behind it as if nothing was wrong."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_text import plain_of
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node

LEAVES = r"\b(?:return|throw|break|continue|goto|exit|_exit|quick_exit|abort|assert|shutdown)\b"
"""By which a function does not go on; a part of a pattern, without braces."""
_LOGS = regex(
    r"(?:RCLCPP|ROS)_(?:DEBUG|INFO|WARN|ERROR|FATAL)\w*\Z|(?:std::)?(?:printf|fprintf|perror)\Z|sleep(?:_for)?\Z"
)
_STREAMS = regex(r"(?:std::)?c(?:out|err)\s{0,4}<<")
_PLAIN = ("expression_statement", "declaration")


def only_log(code: Code, tried: Node) -> Node | None:
    """The first handler of a ``try``, when all of them do nothing but log."""
    handlers = [each for each in tried.named_children if each.type == "catch_clause"]
    return handlers[0] if handlers and all(_only_logs(code, each) for each in handlers) else None


def _only_logs(code: Code, handler: Node) -> bool:
    body = handler.child_by_field_name("body")
    statements = [each for each in body.named_children if each.type != "comment"] if body is not None else []
    return all(each.type == "expression_statement" and _is_log(code, each) for each in statements)


def _is_log(code: Code, statement: Node) -> bool:
    inner = statement.named_children[0] if statement.named_child_count else statement
    call = code.call(inner) if inner.type == "call_expression" else None
    return _LOGS.match(call.name) is not None if call is not None else _STREAMS.match(code.text(inner)) is not None


def behind(code: Code, tried: Node, used: re.Pattern[str], stops: re.Pattern[str]) -> Span | None:
    """What a statement behind a ``try`` uses in each case, unless one up to there may leave, or look."""
    plain = plain_of(code.source)
    following = _following(tried)
    while following:
        each = following.pop()
        span = code.span(each)
        found = used.search(plain, span.start, span.end)
        body = each.child_by_field_name("body") if each.type == "try_statement" else None
        if found is not None and body is not None and body.named_child_count:
            following = body.named_children[::-1]
        elif stops.search(plain, span.start, span.end):
            return None
        elif found is not None:
            return code.source.span(*found.span()) if each.type in _PLAIN else None
    return None


def _following(statement: Node) -> list[Node]:
    """The statements behind one in its block, the next one last."""
    block = statement.parent
    children = block.named_children if block is not None else []
    return [each for each in reversed(children) if each.start_byte >= statement.end_byte]
