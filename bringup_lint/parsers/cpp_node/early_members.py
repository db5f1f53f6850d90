"""Members of C++ classes that are made of a member which is made after them: the order is that of the declarations."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import EarlyMember
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.owners import class_made
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

_NUMBER = regex(
    r"(?:const\s)?(?:std::)?(?:bool|double|float|int|long|short|unsigned(?:\s(?:int|long|char|short))?"
    r"|u?int(?:8|16|32|64)_t|size_t)\Z"
)
_POINTER = regex(r"(?:Shared|Unique)Ptr\b|\b(?:shared|unique)_ptr\s{0,4}<")
_LISTENER = regex(r"\bTransformListener\b")
"""Its constructor calls the buffer (tf2_ros, transform_listener.cpp)."""
_STEPS = frozenset({"pointer_expression", "field_expression"})


class _Field(NamedTuple):
    place: int
    type: str
    name: Node


def early_members(code: Code) -> Iterator[EarlyMember]:
    """One for each member; what a constructor sets itself has no default."""
    made: dict[str, list[Node]] = {}
    for function in code.written.get("function", ()):
        owner = class_made(code, function) if _values(code, function) else None
        if owner is not None:
            made.setdefault(owner, []).append(function)
    classes = [each for each in code.written.get("class", ()) if each.child_by_field_name("body") is not None]
    names = Counter(code.text(each.child_by_field_name("name")) for each in classes)
    for node in classes:
        name, fields = code.text(node.child_by_field_name("name")), dict(_fields(code, node))
        if names[name] > 1:
            continue
        constructors = made.get(name, [])
        for each in constructors:
            yield from _found(code, fields, _values(code, each), frozenset(_parameters(code, each)))
        given = {text for each in constructors for text, _ in _values(code, each)}
        defaults = [(text, value) for text, value in _defaults(code, node) if text not in given]
        yield from _found(code, fields, defaults, frozenset())


def _values(code: Code, function: Node) -> list[tuple[str, Node]]:
    """The members that the list of a constructor sets, and by what."""
    lists = [each for each in function.children if each.type == "field_initializer_list"]
    inits = [each for outer in lists for each in outer.named_children if each.named_child_count > 1]
    return [(code.text(each.named_children[0]), each) for each in inits]


def _fields(code: Code, node: Node) -> Iterator[tuple[str, _Field]]:
    body = node.child_by_field_name("body")
    for place, each in enumerate(body.named_children if body is not None else ()):
        if each.type != "field_declaration" or any(part.type == "storage_class_specifier" for part in each.children):
            continue
        kind = " ".join(code.text(each.child_by_field_name("type")).split())
        for name in each.children_by_field_name("declarator"):
            if name.type == "field_identifier":
                yield code.text(name), _Field(place, kind, name)


def _defaults(code: Code, node: Node) -> Iterator[tuple[str, Node]]:
    body = node.child_by_field_name("body")
    if body is None:
        return
    for each in body.named_children:
        name, value = each.child_by_field_name("declarator"), each.child_by_field_name("default_value")
        if each.type == "field_declaration" and name is not None and value is not None:
            yield code.text(name), value


def _parameters(code: Code, function: Node) -> Iterator[str]:
    declarator = function.child_by_field_name("declarator")
    given = declarator.child_by_field_name("parameters") if declarator is not None else None
    if given is None:
        return
    for each in given.named_children:
        name = each.child_by_field_name("declarator")
        yield code.text(name).lstrip("*& ")


def _found(
    code: Code, fields: dict[str, _Field], given: list[tuple[str, Node]], hidden: frozenset[str]
) -> Iterator[EarlyMember]:
    for name, value in given:
        own = fields.get(name)
        used = next(_later(code, fields, own, value, hidden), None) if own is not None else None
        if own is not None and used is not None:
            later = fields[code.text(used)]
            yield EarlyMember(code.span(used), code.span(own.name), code.span(later.name), name)


def _later(code: Code, fields: dict[str, _Field], own: _Field, value: Node, hidden: frozenset[str]) -> Iterator[Node]:
    """Where a value surely uses a member that is declared after the one which it is for."""
    is_listener = _LISTENER.search(own.type) is not None or _LISTENER.search(code.text(value)) is not None
    todo = [(value, value.parent)]
    while todo:
        node, outer = todo.pop()
        if node.type in ("lambda_expression", "sizeof_expression"):
            continue
        later = fields.get(code.text(node)) if node.type == "identifier" else None
        if later is not None and later.place > own.place and code.text(node) not in hidden:
            if outer is not None and _is_used(code, own, later, (node, outer), is_listener):
                yield node
        todo += ((each, node) for each in reversed(node.named_children))


def _is_used(code: Code, own: _Field, later: _Field, at: tuple[Node, Node], is_listener: bool) -> bool:
    """``at`` is the name and what is around it: tree-sitter looks for a parent from the root on."""
    node, outer = at
    if outer.type in _STEPS:
        is_first = outer.child_by_field_name("argument") == node
        return is_first and _POINTER.search(later.type) is not None and not code.text(outer).startswith("&")
    if _NUMBER.match(later.type):
        return outer.type == "binary_expression" or _NUMBER.match(own.type) is not None
    return is_listener and later.type.endswith("Buffer")
