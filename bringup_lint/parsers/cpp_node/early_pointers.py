"""Shared pointers that objects of a C++ file ask for before anything owns them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import EarlyPointer
from bringup_lint.model.cpp_text import blanked
from bringup_lint.parsers.cpp_node.owners import class_made
from bringup_lint.parsers.cpp_node.owners import class_of
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.waits import Bodies
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from tree_sitter import Node

_CALL = "shared_from_this"
_OWN = regex(r"(?:this->)?(?:(?:rclcpp(?:_lifecycle)?::)?(?:Lifecycle)?Node::)?shared_from_this\Z")
_OWNS = regex(
    r"[sS](?:(?<=s)hared_ptr\s{0,4}<\s{0,4}(?P<type>[\w:]{1,80})\s{0,4}>|(?<=S)haredPtr)"
    r"(?:>\s{0,4}\(|\s{1,4}\w{1,60}\s{0,4}[({]|\s{0,4}[({])\s{0,4}this\s{0,4}[)}]"
)
"""A shared pointer made of ``this`` alone, without a deleter; what is before it is ``_OF``."""
_OF = regex(r"(?:(?P<type>[\w:]{1,80})::|std::)\Z")
_OF_SIZE = 82
_MAY_NOT_RUN = frozenset({"try_statement", "preproc_if", "preproc_ifdef"})


def early_pointers(code: Code) -> Iterator[EarlyPointer]:
    """The calls that every constructor of a class makes, itself or in a method of the class that it calls."""
    if _CALL not in code.source.text:
        return
    bodies = Bodies(code)
    for owner, function, through in while_made(code, bodies):
        for call in _certain(code, bodies, function):
            if _OWN.match(call.qualified):
                yield EarlyPointer(code.span(call.node), owner, through)


def second_owners(code: Code, classes: list[str]) -> Iterator[Located]:
    """``std::shared_ptr<rclcpp::Node>(this)`` and the like: a pointer to a node, which belongs to another already."""
    text = code.source.text
    if "this" not in text or not _OWNS.search(text):
        return
    plain = blanked(text)
    for found in _OWNS.finditer(plain):
        of = _OF.search(plain, max(0, found.start() - _OF_SIZE), found.start())
        kind = (found["type"] or (of["type"] if of is not None else None) or "").rpartition("::")[2]
        if kind in ("Node", "LifecycleNode", *classes) or (not kind and classes):
            yield code.source.located(of.start() if of is not None else found.start(), found.end())


def while_made(code: Code, bodies: Bodies) -> Iterator[tuple[str, Node, Span | None]]:
    """Class, and what certainly runs while it is made: the constructor, or a method with the call that leads there."""
    for function in code.written.get("function", ()):
        owner = class_made(code, function)
        if owner is None:
            continue
        yield owner, function, None
        for call in _certain(code, bodies, function):
            method = _method(code, bodies, call, owner)
            if method is not None:
                yield owner, method, code.span(call.node)


def _method(code: Code, bodies: Bodies, call: Call, owner: str) -> Node | None:
    """The definition of a method of the class itself that a call runs."""
    methods = bodies.functions.get(call.name, ())
    if len(methods) != 1 or call.qualified not in (call.name, f"this->{call.name}"):
        return None
    qualifier = (code.defined_name(methods[0]) or "").rpartition("::")[0]
    return methods[0] if class_of(code, methods[0], qualifier) == owner else None


def _certain(code: Code, bodies: Bodies, function: Node) -> Iterator[Call]:
    """The calls that a function makes whenever it runs, as far as no condition leaves them out."""
    for call in bodies.own(function):
        inside = (each.type for each in code.above(call.node))
        if not code.is_conditional(call.node) and _MAY_NOT_RUN.isdisjoint(inside):
            yield call
