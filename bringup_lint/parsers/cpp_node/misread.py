"""Parameters that a C++ file reads as another type than it declares them with."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.node_source import Misread
from bringup_lint.model.node_source import type_of_default
from bringup_lint.parsers.cpp_node.parameters import constant
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.values import declared
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from tree_sitter import Node

_TYPES = regex(
    r"(?P<double>double|float)\Z|(?P<bool>bool)\Z|(?P<string>std::string|string)\Z"
    r"|(?P<integer>(?:unsigned|signed)?(?:int|long|longlong|short|(?:std::)?(?:u?int(?:8|16|32|64)_t|size_t)))\Z"
)
"""Types of C++, each in a group that is called as the type of a parameter."""
_ANY_TYPE = ("dynamic_typing", "automatically_declare_parameters_from_overrides")
"""In a file that says so, a parameter may have another type than that of its default."""
_READS = {"as_double": "double", "as_int": "integer", "as_bool": "bool", "as_string": "string"}


def misread(code: Code) -> Iterator[Misread]:
    """The reads that throw, of parameters that the file declares with one type."""
    text = code.source.text
    if "get_parameter" not in text or any(word in text for word in _ANY_TYPE):
        return
    types = _declared(code)
    for call in code.calls:
        name = _asked(code, call) if call.name in _READS or call.name == "get_value" else None
        read = _READS.get(call.name) or _type(code, _template(call))
        kinds = types.get(str(name), {}) if name is not None else {}
        if read is not None and len(kinds) == 1 and not _is_guarded(code, call.node):
            kind, place = next(iter(kinds.items()))
            if kind is not None and kind != read:
                yield Misread(code.span(call.node), place, kind, read, f"{call.name}()")


def _declared(code: Code) -> dict[str, dict[str | None, Located]]:
    """Parameter -> the types with which it is declared, each with the place; None for one that is not known."""
    found: dict[str, dict[str | None, Located]] = {}
    for call in code.calls:
        if call.name not in ("declare_parameter", "declare_parameter_if_not_declared"):
            continue
        name, default = declared(code, call)
        if name is not None:
            kind = (
                _type(code, _template(call)) if call.template is not None else type_of_default(constant(code, default))
            )
            found.setdefault(str(name), {})[kind] = name
    return found


def _template(call: Call) -> Node | None:
    given = call.template.named_children if call.template is not None else []
    return given[0] if given else None


def _type(code: Code, node: Node | None) -> str | None:
    found = _TYPES.match("".join(code.text(node).split()))
    return found.lastgroup if found is not None else None


def _asked(code: Code, call: Call) -> Located | None:
    """The parameter of ``get_parameter("...")`` on whose result a method is called."""
    function = call.node.child_by_field_name("function")
    owner = function.child_by_field_name("argument") if function is not None else None
    if owner is None and function is not None and function.named_child_count:
        owner = function.named_children[0].child_by_field_name("argument")
    inner = code.call(owner) if owner is not None and owner.type == "call_expression" else None
    if inner is None or inner.name != "get_parameter" or len(inner.arguments) != 1:
        return None
    return code.literal(inner.arguments[0])


def _is_guarded(code: Code, node: Node) -> bool:
    """Whether a place is in a ``try``, or under a condition on a type."""
    for outer in code.above(node):
        condition = outer.child_by_field_name("condition")
        if outer.type == "try_statement" or "type" in code.text(condition).lower():
            return True
    return False
