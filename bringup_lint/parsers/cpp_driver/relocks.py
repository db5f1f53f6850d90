"""Mutexes of a C++ file that a thread locks while it holds them already."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_driver import Relock
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

LOCKS = regex(r"\b(?:lock_guard|unique_lock|scoped_lock)\b", hints="lock_guard unique_lock scoped_lock")
GUARDS = 500
"""Locks of one file that are looked at."""
DEPTH = 3
"""Calls that are followed to another lock."""
_GUARD = regex(
    r"(?:const\s{1,4})?(?:std::)?(?:lock_guard|unique_lock|scoped_lock)\s{0,4}"
    r"(?:<\s{0,4}(?:std::)?(?P<type>[\w:]{1,60})\s{0,4}>\s{0,4}|\s)"
    r"(?P<name>\w{1,60})\s{0,4}[({]\s{0,4}(?:this->)?(?P<mutex>[A-Za-z_]\w{0,80})\s{0,4}[)}]\s{0,4};"
)
"""A guard of one mutex that the object, the file or the function has."""
PLAIN = ("mutex", "shared_mutex", "timed_mutex", "shared_timed_mutex")
"""Types that the thread that holds them may not lock again."""


class _Lock(NamedTuple):
    node: Node
    """The declaration of the guard."""
    name: str
    mutex: str
    is_typed: bool
    """The guard itself names the type of the mutex."""
    body: Node
    """The function or lambda that it is in."""
    block: Node
    """The block at whose end the guard gives the mutex back."""


def relocks(code: Code) -> Iterator[Relock]:
    """The first call or guard below each lock that locks the same mutex again in each case."""
    functions = _Functions(code)
    for lock in functions.locks:
        again = functions.again(lock)
        if again is not None:
            call, second, through = again
            yield Relock(
                code.span(call), code.span(lock.node), code.span(second.node), lock.mutex, through, lock.is_typed
            )


class _Functions:
    def __init__(self, code: Code) -> None:
        self._code = code
        self._bodies = Bodies(code)
        self.locks = list(islice(_locks(code), GUARDS))
        self._of_body: dict[int, list[_Lock]] = {}
        self._known: dict[tuple[int, str, int], _Lock | None] = {}
        """What is known of a function, a mutex and a depth."""
        for lock in self.locks:
            self._of_body.setdefault(lock.body.id, []).append(lock)

    def again(self, lock: _Lock) -> tuple[Node, _Lock, str | None] | None:
        """The place below a lock that leads to another one of its mutex, that one, and the method that is called."""
        found: list[tuple[Node, _Lock, str | None]] = [
            (each.node, each, None)
            for each in self._of_body[lock.body.id]
            if each.mutex == lock.mutex and lock.node.end_byte <= each.node.start_byte < lock.block.end_byte
        ]
        for call in self._bodies.own(lock.body):
            if lock.node.end_byte <= call.node.start_byte < lock.block.end_byte:
                second = self._locked_by(self._called(call.name, call.qualified, lock.body), lock.mutex, DEPTH)
                if second is not None:
                    found.append((call.node, second, call.name))
        first = min(found, key=lambda each: each[0].start_byte, default=None)
        return None if first is None or self._is_released(lock, first[0]) else first

    def _called(self, name: str, qualified: str, caller: Node) -> Node | None:
        """The one method of the same class that a call of the own object runs."""
        inner = self._bodies.functions.get(name, [])
        if len(inner) != 1 or qualified not in (name, f"this->{name}"):
            return None
        return inner[0] if self._class_of(inner[0]) == self._class_of(caller) else None

    def _locked_by(self, function: Node | None, mutex: str, depth: int) -> _Lock | None:
        """The lock of a mutex that a function takes whenever it does not return before."""
        if function is None or depth == 0:
            return None
        key = (function.id, mutex, depth)
        if key not in self._known:
            self._known[key] = self._locks_itself(function, mutex) or self._locked_inside(function, mutex, depth)
        return self._known[key]

    def _locks_itself(self, function: Node, mutex: str) -> _Lock | None:
        locks = self._of_body.get(function.id, ())
        return next((each for each in locks if each.mutex == mutex and not self._code.is_conditional(each.node)), None)

    def _locked_inside(self, function: Node, mutex: str, depth: int) -> _Lock | None:
        calls = (each for each in self._bodies.own(function) if not self._code.is_conditional(each.node))
        inner = (self._called(call.name, call.qualified, function) for call in calls)
        return next(filter(None, (self._locked_by(each, mutex, depth - 1) for each in inner)), None)

    def _class_of(self, node: Node) -> str:
        """The class of a method or of the method that a lambda is in; empty for a plain function."""
        code = self._code
        outer = node if node.type == "function_definition" else None
        scopes = []
        for each in code.above(node):
            if each.type == "function_definition" and outer is None:
                outer = each
            elif each.type in ("class_specifier", "struct_specifier"):
                scopes.append(code.text(each.child_by_field_name("name")))
        scope = (code.defined_name(outer) or "").rpartition("::")[0] if outer is not None else ""
        return scope.rpartition("::")[2] or (scopes[0] if scopes else "")

    def _is_released(self, lock: _Lock, place: Node) -> bool:
        """Whether something between a lock and a place may give the mutex back."""
        code = self._code
        span = code.source.text[code.offset(lock.node.end_byte) : code.offset(place.start_byte)]
        return any(f"{name}.{call}" in span for name in (lock.name, lock.mutex) for call in ("unlock", "release"))


def _locks(code: Code) -> Iterator[_Lock]:
    for node in code.written.get("declaration", ()):
        found = _GUARD.match(code.text(node))
        block = node.parent
        if found is None or found["type"] not in (*PLAIN, None) or block is None or block.type != "compound_statement":
            continue
        body = code.body_of(node)
        if body is not None:
            yield _Lock(node, found["name"], found["mutex"], found["type"] is not None, body, block)
