"""Threads that a C++ file starts, and which of them only callbacks join."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import LateJoin
from bringup_lint.model.node_source import Callback
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from tree_sitter import Node

_STARTED = regex(
    r"std::thread\s*[({](?!\s*[)}])|std::make_(?:unique|shared)<\s*std::thread\s*>\s*\("
    r"|std::(?:unique|shared)_ptr<\s*std::thread\s*>\s*[({]\s*new\s+std::thread\b"
)
_TARGET = regex(r"(?:this->)?([A-Za-z_]\w*)(?:\[[^\]]*\])?\Z")
_DECLARED = regex(r"std::thread\s+\w+\s*[({]")
_ENDS_AT_ONCE = regex(r"\b(?:_exit|_Exit|quick_exit|abort|terminate)\s{0,4}\(", hints="xit abort terminate")
"""What ends a program without destroying its objects, or on purpose."""

_STEPS = frozenset({"on_cleanup", "on_deactivate", "on_shutdown", "on_error"})
"""Transitions of a lifecycle node, none of which Ctrl-C runs."""


def threads(code: Code) -> Iterator[Located]:
    """The variables and members that hold a thread from here on. A thread that ``new`` makes is never
    destroyed, unless a smart pointer gets it."""
    for node in code.written.get("assignment", ()):
        if _STARTED.match(code.text(node.child_by_field_name("right"))):
            target = _TARGET.match(code.text(node.child_by_field_name("left")))
            if target is not None:
                yield Located(target[1], code.span(node))
    for node in code.written.get("made", ()):
        name, value = (code.text(node.child_by_field_name(field)) for field in ("declarator", "value"))
        whole = code.text(node.parent) if node.parent is not None else ""
        if _TARGET.match(name) and (_STARTED.match(value) or _DECLARED.match(whole)):
            yield Located(name, code.span(node))


def late_joins(code: Code, started: list[Located], callbacks: list[Callback]) -> Iterator[LateJoin]:
    """The members that hold a thread, where all of their joins are in callbacks or transitions that nothing calls."""
    names = dict.fromkeys(str(each) for each in started)
    joins = [call for call in code.calls if call.name == "join"] if names else []
    if not joins or _ENDS_AT_ONCE.search(code.source.text):
        return
    bodies = Bodies(code)
    called = {call.name for call in code.calls}
    runs = {body.id: each for each in callbacks if (body := bodies.of(each)) is not None and each.name not in called}
    for step in _STEPS - called:
        for body in bodies.functions.get(step, ()):
            runs[body.id] = Callback("transition", step, code.span(body))
    by_thread: dict[str, list[Call]] = {}
    for call in joins:
        by_thread.setdefault(_receiver(call), []).append(call)
    for name in names:
        own = by_thread.get(name, [])
        callback = _common(code, own, runs) if own and not _is_local(code, name) else None
        if callback is not None:
            where = f"{callback.name}()" if callback.name else "a lambda"
            is_step = callback.role == "transition"
            yield LateJoin(name, tuple(code.span(call.node) for call in own), where, is_step)


def _receiver(call: Call) -> str:
    return call.qualified.removeprefix("this->").removesuffix(call.name).rstrip("->.")


def _common(code: Code, joins: list[Call], runs: dict[int, Callback]) -> Callback | None:
    """The first of the callbacks that hold all of the joins; None when another function holds one."""
    functions = [code.body_of(call.node) for call in joins]
    found = [runs.get(each.id) if each is not None else None for each in functions]
    return found[0] if None not in found else None


def _is_local(code: Code, name: str) -> bool:
    """Whether a function declares a thread of this name."""
    declared = (each for each in code.written.get("declaration", ()) if "thread" in code.text(each))
    return any(code.is_inside_function(each) and _declares(code, each, name) for each in declared)


def _declares(code: Code, declaration: Node, name: str) -> bool:
    written = declaration.children_by_field_name("declarator")
    inner = [each.child_by_field_name("declarator") or each for each in written]
    return any(code.text(each).lstrip("*& ") == name for each in inner)
