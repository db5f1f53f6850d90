"""Threads that a C++ file starts."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_STARTED = regex(
    r"std::thread\s*[({](?!\s*[)}])|std::make_(?:unique|shared)<\s*std::thread\s*>\s*\("
    r"|std::(?:unique|shared)_ptr<\s*std::thread\s*>\s*[({]\s*new\s+std::thread\b"
)
_TARGET = regex(r"(?:this->)?([A-Za-z_]\w*)(?:\[[^\]]*\])?\Z")
_DECLARED = regex(r"std::thread\s+\w+\s*[({]")


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
