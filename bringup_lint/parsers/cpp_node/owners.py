"""Of which class a function of a C++ file is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.parsers.cpp_node.syntax import Code

if TYPE_CHECKING:
    from tree_sitter import Node


def class_made(code: Code, function: Node) -> str | None:
    """The class of which a definition is a constructor."""
    if function.child_by_field_name("type") is not None:
        return None
    qualifier, _, name = (code.defined_name(function) or "").rpartition("::")
    return name if name and class_of(code, function, qualifier) == name else None


def class_of(code: Code, function: Node, qualifier: str) -> str:
    """The class of a method: by its qualified name, or the class that its definition is in."""
    if qualifier:
        return qualifier.rpartition("::")[2]
    outer = next((each for each in code.above(function) if each.type in ("class_specifier", "struct_specifier")), None)
    return code.text(outer.child_by_field_name("name")) if outer is not None else ""
