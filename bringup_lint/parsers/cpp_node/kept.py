"""What callbacks of a C++ file keep of their messages, and what other callbacks send of that."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

    from bringup_lint.model.node_source import Callback

_SENDS = regex(r"(?i)(?:publish|write|send|set_?(?:motor|speed|velocity|pwm|wheel)\w*|drive)\Z")
_WORD = regex(r"[A-Za-z_]\w*")


def kept(code: Code, callbacks: list[Callback]) -> dict[int, frozenset[str]]:
    """Where the callback of a subscription is handed over -> the members that it fills from its message, and that
    nothing else fills."""
    bodies = Bodies(code)
    assignments = _Assignments(code)
    found: dict[int, frozenset[str]] = {}
    for callback in callbacks:
        body = bodies.of(callback) if callback.role == "subscription" else None
        if body is not None:
            taken = (assignments.filled(each) for each in (body, *_handed_on(code, bodies, body)))
            found[callback.span.start] = frozenset().union(*taken)
    return found


def _handed_on(code: Code, bodies: Bodies, body: Node) -> Iterator[Node]:
    """The methods of the file to which a lambda hands its message."""
    if body.type != "lambda_expression":
        return
    for call in bodies.own(body):
        inner = bodies.functions.get(call.name, [])
        if call.arguments and len(inner) == 1 and call.qualified in (call.name, f"this->{call.name}"):
            yield inner[0]


def sent(code: Code, callbacks: list[Callback], role: str = "timer") -> dict[int, frozenset[str]]:
    """Where the callback of a timer that sends something is handed over -> the words of what it runs."""
    bodies = Bodies(code)
    words_of: dict[int, frozenset[str]] = {}

    def words(node: Node) -> frozenset[str]:
        if node.id not in words_of:
            words_of[node.id] = frozenset(_WORD.findall(code.text(node)))
        return words_of[node.id]

    found: dict[int, frozenset[str]] = {}
    for callback in callbacks:
        body = bodies.of(callback) if callback.role == role else None
        if body is None:
            continue
        calls = [each for each in bodies.reached(body) if isinstance(each, Call)]
        if any(_SENDS.match(call.name) for call in calls):
            inner = (bodies.functions.get(name, []) for name in dict.fromkeys(call.name for call in calls))
            nodes = (body, *(function for functions in inner for function in functions))
            found[callback.span.start] = frozenset().union(*map(words, nodes))
    return found


def called(code: Code, callbacks: list[Callback]) -> dict[int, frozenset[str]]:
    """Where a callback is handed over -> the functions that it calls, itself and through methods of the file."""
    bodies = Bodies(code)
    found: dict[int, frozenset[str]] = {}
    for callback in callbacks:
        body = bodies.of(callback)
        if body is not None:
            found[callback.span.start] = frozenset(each.name for each in bodies.reached(body) if isinstance(each, Call))
    return found


class _Assigned(NamedTuple):
    """An assignment of the file."""

    node: Node
    target: str
    """The variable or member whose value, or a part of it, is assigned."""
    elsewhere: bool
    """Whether it counts against a callback that it is not in: those of constructors do not."""


class _Assignments:
    """The assignments of a file, in its order."""

    def __init__(self, code: Code) -> None:
        self._code = code
        nodes = sorted(code.written.get("assignment", ()), key=lambda node: node.start_byte)
        targets = [_WORD.match(_left(code, node)) for node in nodes]
        self._all = [
            _Assigned(node, target[0], not _is_constructor(code, node))
            for node, target in zip(nodes, targets, strict=True)
            if target is not None
        ]
        self._starts = [each.node.start_byte for each in self._all]
        self._elsewhere = Counter(each.target for each in self._all if each.elsewhere)
        self._local = frozenset(
            code.text(node.child_by_field_name("declarator")).lstrip("*& ") for node in code.written.get("made", ())
        )

    def filled(self, body: Node) -> frozenset[str]:
        """What a callback assigns from its message, and that nothing else assigns."""
        header, _, _ = self._code.text(body).partition("{")
        names = _WORD.findall(header.rpartition(")")[0])
        if not names:
            return frozenset()
        message = re.compile(rf"\b{re.escape(names[-1])}\b")
        own = [each for each in self._within(body) if each.node.end_byte <= body.end_byte]
        inside = {each.target for each in own if message.search(self._right(each.node))}
        counts = Counter(each.target for each in own if each.elsewhere)
        return frozenset(name for name in inside - self._local if self._elsewhere[name] == counts[name])

    def _within(self, body: Node) -> list[_Assigned]:
        return self._all[bisect_left(self._starts, body.start_byte) : bisect_left(self._starts, body.end_byte)]

    def _right(self, node: Node) -> str:
        return self._code.text(node.child_by_field_name("right"))


def _left(code: Code, node: Node) -> str:
    return code.text(node.child_by_field_name("left")).removeprefix("this->")


def _is_constructor(code: Code, node: Node) -> bool:
    head, colons, name = (code.function_name(node) or "").rpartition("::")
    return bool(colons) and head.rpartition("::")[2] == name
