"""Mutexes of a C++ file that a function locks by hand, and leaves locked by an early ``return``."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import LeftLocked
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

BY_HAND = regex(r"(?:\.|pthread_mutex_)lock\s{0,4}\(", hints=".lock pthread_mutex_lock")
MOST = 200
"""Locks of one file that are looked at."""
_MUTEX = regex(r"(?i)mutex|mtx")
"""The name of one that no guard has: a guard unlocks where its scope ends."""
_NAME = regex(r"(?:this->)?&?\s{0,4}(?:this->)?([A-Za-z_]\w{0,80})\Z")


def left_locked(code: Code) -> Iterator[LeftLocked]:
    """The first ``return`` between each lock and the statement of the same block that unlocks."""
    calls = ((each, name) for each in code.calls if (name := _locked(code, each)) is not None)
    for call, name in islice(calls, MOST):
        region = _region(code, call, name)
        left = _left(code, region) if region else None
        if left is not None:
            yield LeftLocked(code.span(left), code.span(call.node), name)


def _locked(code: Code, call: Call) -> str | None:
    """The mutex that a statement locks."""
    statement = call.node.parent
    if statement is None or statement.type != "expression_statement":
        return None
    if call.qualified == "pthread_mutex_lock" and call.arguments:
        found = _NAME.match(code.text(call.arguments[0]))
        return found[1] if found is not None else None
    found = _NAME.match(call.qualified.removesuffix(".lock")) if call.name == "lock" and not call.arguments else None
    if found is None or not _MUTEX.search(found[1]):
        return None
    guard = rf"_(?:lock|guard)\b[^;]{{0,100}}\b{re.escape(found[1])}\s*[;({{]"
    return found[1] if re.search(guard, code.source.text) is None else None


def _region(code: Code, call: Call, name: str) -> list[Node]:
    """The statements from a lock to the one that unlocks in the same block; empty when there is none."""
    statement = call.node.parent
    block = statement.parent if statement is not None else None
    if statement is None or block is None or block.type != "compound_statement":
        return []
    word = re.escape(name)
    unlocks = re.compile(rf"(?:this->)?{word}\.unlock\s*\(|pthread_mutex_unlock\s*\(\s*&?\s*(?:this->)?{word}\b")
    after = [each for each in block.named_children if each.start_byte >= statement.end_byte]
    ends = (index for index, each in enumerate(after) if unlocks.match(code.text(each)))
    return after[: next(ends, 0)]


def _left(code: Code, region: list[Node]) -> Node | None:
    """The first ``return`` of statements, when nothing before it may unlock."""
    todo = list(reversed(region))
    while todo:
        node = todo.pop()
        if node.type == "return_statement":
            between = code.source.text[code.offset(region[0].start_byte) : code.offset(node.end_byte)]
            return None if "unlock" in blanked(between) else node
        if node.type != "lambda_expression":
            todo += reversed(node.named_children)
    return None
