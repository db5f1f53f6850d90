"""Where components and lifecycle nodes of a C++ file end the process that they were loaded into."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.cpp_source import ComponentEnd
from bringup_lint.parsers.cpp_node.early_pointers import class_of
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

_PROCESS = frozenset(
    f"{scope}{name}" for scope in ("", "std::", "::") for name in ("exit", "_exit", "quick_exit", "abort", "terminate")
)
_CONTEXT = "rclcpp::shutdown"


_STEP = regex(r"on_?(?:[cC]onfigure|[aA]ctivate|[dD]eactivate|[cC]leanup|[eE]rror)\Z")


def component_ends(code: Code, components: list[str]) -> Iterator[ComponentEnd]:
    """The calls in the methods of components, and in transitions of lifecycle nodes, in the order of the text."""
    by_class = {each.rpartition("::")[2]: each for each in components}
    for call in code.calls:
        is_context = call.qualified == _CONTEXT
        if not is_context and call.qualified not in _PROCESS:
            continue
        owner, method = _method(code, call)
        if owner in by_class:
            yield ComponentEnd(code.span(call.node), call.qualified, by_class[owner], None, is_context)
        elif owner and _STEP.match(method):
            yield ComponentEnd(code.span(call.node), call.qualified, owner, method, is_context)


def _method(code: Code, call: Call) -> tuple[str, str]:
    """The class and the name of the method that a call is in; empty texts where it is in none."""
    method = next((each for each in code.above(call.node) if each.type == "function_definition"), None)
    if method is None:
        return "", ""
    qualifier, _, name = (code.defined_name(method) or "").rpartition("::")
    return class_of(code, method, qualifier), name
