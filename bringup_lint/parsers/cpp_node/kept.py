"""What callbacks of a C++ file keep of their messages, and what other callbacks send of that."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

    from bringup_lint.model.node_source import Callback

_SENDS = regex(r"(?i)(?:publish|write|send|set_?(?:motor|speed|velocity|pwm|wheel)\w*|drive)\Z")
_WORD = regex(r"[A-Za-z_]\w*")


def kept(code: Code, callbacks: list[Callback]) -> dict[str, frozenset[str]]:
    """Callback of a subscription -> the members that it fills from its message, and that nothing else fills."""
    bodies = Bodies(code)
    found: dict[str, frozenset[str]] = {}
    for callback in callbacks:
        if callback.name in found:
            continue
        body = bodies.of(callback) if callback.role == "subscription" and callback.name else None
        if callback.name is not None and body is not None:
            found[callback.name] = frozenset(_filled(code, body))
    return found


def sent(code: Code, callbacks: list[Callback]) -> dict[str, frozenset[str]]:
    """Callback of a timer that sends something -> the words of what it runs."""
    bodies = Bodies(code)
    found: dict[str, frozenset[str]] = {}
    for callback in callbacks:
        if callback.name in found:
            continue
        body = bodies.of(callback) if callback.role == "timer" else None
        if body is None:
            continue
        calls = [each for each in bodies.reached(body) if isinstance(each, Call)]
        if any(_SENDS.match(call.name) for call in calls):
            inner = [function for call in calls for function in bodies.functions.get(call.name, [])]
            words = frozenset(word for node in (body, *inner) for word in _WORD.findall(code.text(node)))
            found[callback.name or "a lambda"] = words
    return found


def _filled(code: Code, body: Node) -> set[str]:
    header, _, _ = code.text(body).partition("{")
    names = _WORD.findall(header.rpartition(")")[0])
    if not names:
        return set()
    message = re.compile(rf"\b{names[-1]}\b")
    inside, outside = set(), set()
    for node in code.written.get("assignment", ()):
        left = code.text(node.child_by_field_name("left")).removeprefix("this->")
        target = _WORD.match(left)
        if target is None:
            continue
        own = body.start_byte <= node.start_byte and node.end_byte <= body.end_byte
        if own and message.search(code.text(node.child_by_field_name("right"))):
            inside.add(target[0])
        elif not own and not _is_constructor(code, node):
            outside.add(target[0])
    local = {code.text(node.child_by_field_name("declarator")).lstrip("*& ") for node in code.written.get("made", ())}
    return inside - outside - local


def _is_constructor(code: Code, node: Node) -> bool:
    head, colons, name = (code.function_name(node) or "").rpartition("::")
    return bool(colons) and head.rpartition("::")[2] == name
