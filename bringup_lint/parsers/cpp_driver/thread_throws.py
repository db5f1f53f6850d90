"""Exceptions that leave the function of a thread, where nothing takes them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import ThreadThrow
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.syntax import FUNCTIONS
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

STARTS = regex(
    r"\bstd::thread\s{0,4}(?:\w{1,60}\s{0,4})?[({]|\bmake_(?:unique|shared)<\s{0,4}std::thread\s{0,4}>\s{0,4}\(",
    hints="std::thread",
)
ENDS = regex(r"\bthrow\s{1,4}[\w:]", hints="throw")
DEPTH = 3
"""Calls of functions of the file that are followed."""
_METHOD = regex(r"\s{0,40}(?:std::bind\s{0,4}\(\s{0,40})?&\s{0,4}(?:\w+::){0,6}(?P<name>\w+)\s{0,4}[,)}]")
_LAMBDA = regex(r"\s{0,40}\[")
_ASKS_SYSTEM = regex(
    r"(?<![\w.>])(?:::)?(?:socket|bind|listen|accept|connect|setsockopt|ioctl|tcsetattr|tcgetattr|open|recv|recvfrom)\s{0,4}\("
    r"|(?:\b|_)[fF]uture\w{0,40}\s{0,4}\.\s{0,4}get\s{0,4}\(|\blookupTransform\s{0,4}\("
)
"""What another node, a device or the system answers: it may fail on any day."""


def thread_throws(code: Code) -> Iterator[ThreadThrow]:
    """The first for each thread, where a function throws after the system, a device or another node has answered."""
    throws = _throws(code)
    if not throws:
        return
    bodies = Bodies(code)
    for found in STARTS.finditer(blanked(code.source.text)):
        body = _run(code, bodies, found.end())
        thrown = _thrown(code, bodies, body, throws) if body is not None else None
        if thrown is not None:
            yield ThreadThrow(code.span(thrown[0]), code.source.span(found.start(), found.end() - 1), thrown[1])


def _throws(code: Code) -> dict[int, list[Node]]:
    """Function -> where it throws what it does not take itself."""
    found: dict[int, list[Node]] = {}
    for each in code.written.get("throw", ()):
        function = code.body_of(each)
        if function is not None and each.named_child_count and not _is_taken(code, each, function):
            found.setdefault(function.id, []).append(each)
    return found


def _is_taken(code: Code, node: Node, function: Node) -> bool:
    inner = node
    for outer in code.above(node):
        if outer.id == function.id:
            break
        if outer.type == "try_statement" and outer.child_by_field_name("body") == inner:
            return True
        inner = outer
    return False


def _is_handled(code: Code, thrown: Node) -> bool:
    """Whether something else has failed before."""
    for outer in code.above(thrown):
        if outer.type == "catch_clause":
            return True
        if outer.type in FUNCTIONS:
            break
    return False


def _run(code: Code, bodies: Bodies, start: int) -> Node | None:
    """The method or lambda that a thread is made with, from its first argument on."""
    text = code.source.text
    method = _METHOD.match(text, start)
    if method is not None:
        named = bodies.functions.get(method["name"], [])
        return named[0] if len(named) == 1 else None
    lambdas = code.written.get("lambda", ()) if _LAMBDA.match(text, start) else ()
    return next((each for each in lambdas if code.span(each).start >= start), None)


def _thrown(code: Code, bodies: Bodies, body: Node, throws: dict[int, list[Node]]) -> tuple[Node, str] | None:
    todo, seen = [(body, 0)], {body.id}
    while todo:
        function, depth = todo.pop()
        for each in throws.get(function.id, ()):
            before = code.source.text[code.span(function).start : code.span(each).start]
            if _ASKS_SYSTEM.search(blanked(before)) or _is_handled(code, each):
                return each, (code.defined_name(function) or "").rpartition("::")[2] or "the lambda"
        if depth == DEPTH:
            continue
        for call in bodies.own(function):
            inner = bodies.functions.get(call.name, [])
            own = call.qualified in (call.name, f"this->{call.name}") and not _is_taken(code, call.node, function)
            if own and len(inner) == 1 and inner[0].id not in seen:
                seen.add(inner[0].id)
                todo.append((inner[0], depth + 1))
    return None
