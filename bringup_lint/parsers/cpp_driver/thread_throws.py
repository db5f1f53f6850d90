"""Exceptions that leave the function of a thread, where nothing takes them."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import ThreadThrow
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.parsers.cpp_node.owners import class_of
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
_NEAR = 300
"""Characters before the start of a thread that are looked at."""
_IF_FILLED = regex(
    r"\bif\s{0,4}\(\s{0,4}!\s{0,4}(?P<name>\w{1,80})\s{0,4}\.\s{0,4}empty\s{0,4}\(\s{0,4}\)\s{0,4}\)\s{0,40}\{?\s{0,80}"
    r"(?:std::thread\s{1,4})?(?:\w{1,80}\s{0,4}=\s{0,40})?\Z",
    hints="empty",
)
_METHOD = regex(r"\s{0,40}(?:std::bind\s{0,4}\(\s{0,40})?&\s{0,4}(?P<scope>(?:\w+::){0,6})(?P<name>\w+)\s{0,4}[,)}]")
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
    lambdas = [(code.span(each).start, each) for each in code.written.get("lambda", ())]
    thrown = _Thrown(code, bodies, _serious(code, throws))
    for found in STARTS.finditer(plain_of(code.source)):
        body = _run(code, bodies, lambdas, found.end())
        place = thrown.by(body, DEPTH) if body is not None else None
        if place is not None:
            started = code.source.span(found.start(), found.end() - 1)
            yield ThreadThrow(code.span(place[0]), started, place[1], _queue(code, found.start()))


def _queue(code: Code, start: int) -> str:
    """The container in the condition of the branch that a thread is the first of."""
    before = plain_of(code.source)[max(0, start - _NEAR) : start]
    found = _IF_FILLED.search(before)
    return found["name"] if found is not None else ""


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


def _serious(code: Code, throws: dict[int, list[Node]]) -> dict[int, Node]:
    """Function -> the first place where it throws because of an answer."""
    asked = [each.span() for each in _ASKS_SYSTEM.finditer(plain_of(code.source))]
    found: dict[int, Node] = {}
    for function, places in throws.items():
        body = code.body_of(places[0])
        at = bisect_left(asked, (code.span(body).start if body is not None else 0, 0))
        first = asked[at][1] if at < len(asked) else len(code.source.text)
        serious = (each for each in places if first <= code.span(each).start or _is_handled(code, each))
        found.update((function, each) for each in islice(serious, 1))
    return found


def _run(code: Code, bodies: Bodies, lambdas: list[tuple[int, Node]], start: int) -> Node | None:
    """The method or lambda that a thread is made with, from its first argument on."""
    text = code.source.text
    method = _METHOD.match(text, start)
    if method is not None:
        named = bodies.functions.get(method["name"], [])
        return named[0] if len(named) == 1 and _is_in(code, named[0], method["scope"]) else None
    at = bisect_left(lambdas, start, key=lambda each: each[0]) if _LAMBDA.match(text, start) else len(lambdas)
    return lambdas[at][1] if at < len(lambdas) else None


def _is_in(code: Code, function: Node, scope: str) -> bool:
    """Whether a function is one of the class before its name."""
    owner = class_of(code, function, (code.defined_name(function) or "").rpartition("::")[0])
    return not owner or not scope or scope.split("::")[-2] == owner


class _Thrown:
    """What leaves the functions of a file."""

    def __init__(self, code: Code, bodies: Bodies, throws: dict[int, Node]) -> None:
        self._code = code
        self._bodies = bodies
        self._throws = throws
        self._inner: dict[int, list[Node]] = {}
        self._known: dict[tuple[int, int], tuple[Node, str] | None] = {}

    def by(self, function: Node, depth: int) -> tuple[Node, str] | None:
        """Where a function throws, or one that it calls; and the name of that one."""
        asked = (function.id, depth)
        if asked not in self._known:
            self._known[asked] = self._found(function, depth)
        return self._known[asked]

    def _found(self, function: Node, depth: int) -> tuple[Node, str] | None:
        thrown = self._throws.get(function.id)
        if thrown is not None:
            return thrown, (self._code.defined_name(function) or "").rpartition("::")[2] or "the lambda"
        inner = (self.by(each, depth - 1) for each in self._called(function)) if depth else iter(())
        return next((each for each in inner if each is not None), None)

    def _called(self, function: Node) -> list[Node]:
        """The functions of the file that a function calls, and whose exceptions it does not take."""
        if function.id not in self._inner:
            found: dict[int, Node] = {}
            for call in self._bodies.own(function):
                named = self._bodies.functions.get(call.name, [])
                own = len(named) == 1 and call.qualified in (call.name, f"this->{call.name}")
                if own and named[0].id not in found and not _is_taken(self._code, call.node, function):
                    found[named[0].id] = named[0]
            self._inner[function.id] = list(found.values())
        return self._inner[function.id]
