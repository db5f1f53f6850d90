"""The parameters that a C++ file declares and reads."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Read
from bringup_lint.model.node_source import Parameter
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.values import declared
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

DECLARING = ("declare_parameter", "declare_parameters", "declare_parameter_if_not_declared", "declare_or_get_parameter")
_READING = {"get_parameter": True, "get_parameter_or": False, "has_parameter": False}
_NUMBER = regex(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?\Z")


def declarations(code: Code, call: Call) -> Iterator[Parameter]:
    """What a call declares under a literal name."""
    if call.name not in DECLARING or call.name == "declare_parameters":
        return
    name, default = declared(code, call)
    if name is not None:
        value = constant(code, default)
        yield Parameter(name, value, value is not None, code.span(call.node))


def is_open(code: Code, call: Call) -> bool:
    """Whether a call may declare names that are not written in it."""
    if call.name == "declare_parameters":
        return True
    return call.name in DECLARING and declared(code, call)[0] is None


def constant(code: Code, node: Node | None) -> str | int | float | bool | None:
    """A literal text, number or truth value."""
    node = code.unwrapped(node)
    text = code.literal(node)
    if text is not None:
        return text
    written = code.text(node).strip()
    if written in ("true", "false"):
        return written == "true"
    bare = written.rstrip("uUlLfF")
    if not _NUMBER.match(bare):
        return None
    return float(bare) if re.search(r"[.eE]", bare) else int(bare)


def reads(code: Code, call: Call) -> Iterator[Read]:
    """``get_parameter("name")``; with a second argument it answers false instead of raising."""
    if call.name in _READING and call.arguments:
        name = code.literal(call.arguments[0])
        if name is not None:
            yield Read(name, _READING[call.name] and len(call.arguments) == 1)
