"""Messages that a callback of a C++ file keeps while another thread reads the one before."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import MessageRace
from bringup_lint.model.node_source import Callback
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

LOCKS = regex(
    r"(?i)mutex|_lock\b|lock_|\block\s{0,2}\(|realtime_?(?:buffer|box|thread)|atomic|nonrt|semaphore|lock_?free"
)
"""What hands messages from one thread to another, anywhere in a source."""
_THREAD = regex(
    r"(?:std::)?thread\b[^;&]{0,120}[({]\s{0,40}(?:std::bind\s{0,4}\(\s{0,40})?&\s{0,4}(?:\w{1,80}::){0,4}(?P<name>\w{1,80})"
)
_UPDATES = frozenset({"update", "update_and_write_commands", "update_reference_from_subscribers"})
_WORD = regex(r"[A-Za-z_]\w*")
_MEMBER = regex(r"(?:this->)?([A-Za-z_]\w*)\Z")
_SPINS = regex(r"\bspin\w{0,30}\s{0,4}\(")


class _Reader(NamedTuple):
    name: str
    functions: list[Node]
    """What the thread runs, and the methods of the file that this calls."""
    is_update: bool


def races(code: Code, callbacks: list[Callback]) -> Iterator[MessageRace]:
    """The members that hold a whole message, in a file that locks nothing, each once."""
    text = code.source.text
    subscribed = [each for each in callbacks if each.role == "subscription"]
    if not subscribed or LOCKS.search(text):
        return
    bodies = Bodies(code)
    readers = list(_readers(code, bodies))
    if not readers:
        return
    told: set[str] = set()
    for callback, name, node in _kept(code, bodies, subscribed):
        found = next(_reads(code, readers, name), None) if name not in told else None
        if found is not None and not _is_local(code, name):
            told.add(name)
            reader, read = found
            where = f"{callback.name}()" if callback.name else "a lambda"
            yield MessageRace(code.span(node), code.span(read), name, where, reader.name, reader.is_update)


def _kept(code: Code, bodies: Bodies, callbacks: list[Callback]) -> Iterator[tuple[Callback, str, Node]]:
    """The members that get whole messages, and where."""
    for callback in callbacks:
        body = bodies.of(callback)
        if body is not None:
            yield from ((callback, name, node) for name, node in _replaced(code, body))


def _readers(code: Code, bodies: Bodies) -> Iterator[_Reader]:
    """The functions that other threads than those of executors run."""
    started = {found["name"] for found in _THREAD.finditer(code.source.text)}
    updates = _UPDATES if "controller_interface" in code.source.text else frozenset()
    for name in sorted(started | updates):
        named = bodies.functions.get(name, [])
        calls = [each for body in named[:1] for each in bodies.reached(body) if isinstance(each, Call)]
        inner = (bodies.functions.get(each, []) for each in dict.fromkeys(call.name for call in calls))
        functions = [*named, *(each for found in inner if len(found) == 1 for each in found)]
        if len(named) == 1 and not any(_SPINS.search(code.text(each)) for each in functions):
            yield _Reader(name, functions, name in updates and name not in started)


def _replaced(code: Code, body: Node) -> Iterator[tuple[str, Node]]:
    """The members to which a callback assigns its whole message."""
    header, _, _ = code.text(body).partition("{")
    names = _WORD.findall(header.rpartition(")")[0])
    message = names[-1] if names else ""
    whole = (message, f"*{message}", f"std::move({message})")
    for node in code.written.get("assignment", ()):
        if body.start_byte < node.start_byte < body.end_byte:
            target = _MEMBER.match(code.text(node.child_by_field_name("left")))
            value = "".join(code.text(node.child_by_field_name("right")).split())
            if target is not None and message and value in whole:
                yield target[1], node


def _reads(code: Code, readers: list[_Reader], name: str) -> Iterator[tuple[_Reader, Node]]:
    for node in code.uses(name):
        for reader in readers:
            if any(each.start_byte < node.start_byte < each.end_byte for each in reader.functions):
                yield reader, node


def _is_local(code: Code, name: str) -> bool:
    """Whether a function declares a variable of this name."""
    declared = re.compile(rf"[\w>&*]\s+[&*]{{0,2}}{re.escape(name)}\s*(?:[=;({{]|$)")
    inside = (each for each in code.written.get("declaration", ()) if code.is_inside_function(each))
    return any(declared.search(code.text(each)) for each in inside)
