"""Waits of C++ sources for a condition variable that look at nothing before."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import BlindWait
from bringup_lint.parsers.cpp_node.syntax import FUNCTIONS
from bringup_lint.parsers.cpp_node.syntax import LOOPS
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

WAITS = regex(r"\bwait\s{0,4}\(\s{0,4}\w{1,80}\s{0,4}\)\s{0,4};", hints="wait")
_LOCK = regex(
    r"(?:std::|boost::)?unique_lock\b\s{0,4}(?:<[^<>;]{0,80}(?:<[^<>;]{0,80}>)?\s{0,4}>)?\s{0,4}(\w{1,80})\s{0,4}[({][^,;]{1,120}[)}]\s{0,4};\Z"
)
_FOR_NEWS = regex(r"(?i)next|new|status|state|data|frame|image|scan|update|latest|message|packet|sample|tick")
"""Words of a function that waits for one more of what keeps coming."""


def blind_waits(code: Code) -> Iterator[BlindWait]:
    """``cv.wait(lock)`` right after the lock is taken, in no loop."""
    for call in code.calls:
        if call.name == "wait" and len(call.arguments) == 1 and call.arguments[0].type == "identifier":
            lock = _lock(code, call)
            if lock is not None and not _is_repeated(code, call) and not _FOR_NEWS.search(_function(code, call)):
                owner = call.qualified.removesuffix("wait").removesuffix("->").removesuffix(".").removeprefix("this->")
                yield BlindWait(code.span(call.node), code.span(lock), owner)


def _lock(code: Code, call: Call) -> Node | None:
    """The declaration just before a wait that takes the lock which it is given."""
    statement = call.node.parent
    if statement is None or statement.type != "expression_statement":
        return None
    before = statement.prev_named_sibling
    while before is not None and before.type == "comment":
        before = before.prev_named_sibling
    found = _LOCK.match(code.text(before)) if before is not None and before.type == "declaration" else None
    return before if found is not None and found[1] == code.text(call.arguments[0]) else None


def _is_repeated(code: Code, call: Call) -> bool:
    """Whether a loop of the function waits again."""
    for outer in code.above(call.node):
        if outer.type in LOOPS:
            return True
        if outer.type in FUNCTIONS:
            return False
    return True


def _function(code: Code, call: Call) -> str:
    return (code.function_name(call.node) or "").rpartition("::")[2]
