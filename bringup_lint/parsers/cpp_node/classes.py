"""The classes of nodes in a C++ file, the names that nodes give themselves, and registered components."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from tree_sitter import Node

_BASES = regex(r"(?:^|::)(?:Lifecycle)?Node\Z")
_LIFECYCLE = regex(r"[:,]\s{0,40}(?:public\s{1,4})?(?:\w{1,40}::)?LifecycleNode\b", hints="LifecycleNode")
"""As a base, or among the initializers of a constructor."""
_COMPONENT = regex(
    r"^[ \t]*RCLCPP_COMPONENTS_REGISTER_NODE\s*\(\s*(?P<name>[\w:]+)\s*\)",
    re.M,
    hints="RCLCPP_COMPONENTS_REGISTER_NODE",
)
_MAKERS = ("make_shared", "make_unique")


def node_classes(code: Code) -> list[str]:
    """Classes that build on a node, in the order of the text."""
    found = []
    for node in code.written.get("class", ()):
        clause = next((each for each in node.named_children if each.type == "base_class_clause"), None)
        bases = ["".join(code.text(each).split()) for each in clause.named_children] if clause is not None else []
        if any(_BASES.search(base) for base in bases):
            found.append(code.text(node.child_by_field_name("name")))
    return found


def components(code: Code) -> list[str]:
    return [found["name"] for found in _COMPONENT.finditer(code.source.text)]


def activation(code: Code) -> Located | None:
    """Where a file of a lifecycle node defines ``on_activate``; None when it does not, or for several nodes."""
    if not _LIFECYCLE.search(code.source.text):
        return None
    named = [(each, code.defined_name(each) or "") for each in code.written.get("function", ())]
    found = [each for each, name in named if name.rpartition("::")[2] == "on_activate"]
    if len(found) != 1:
        return None
    whole = code.span(found[0])
    start = whole.source.text.index("on_activate", whole.start)
    return code.source.located(start, start + len("on_activate"))


def node_names(code: Code) -> list[Located]:
    """The literal first arguments of node constructors, in the order of the text."""
    found = [name for node in _constructions(code) if (name := code.literal(node)) is not None]
    return sorted(found, key=lambda name: name.span.start)


def _constructions(code: Code) -> Iterator[Node]:
    """The first arguments where a node is made: as a base, by ``make_shared``, or as a variable."""
    for node in code.written.get("initializer", ()):
        name = "".join(code.text(node.named_children[0]).split()) if node.named_child_count > 1 else ""
        if _BASES.search(name):
            yield from _first(node.named_children[1])
    for call in code.calls:
        template = "".join(code.text(call.template).split()).strip("<>")
        plain = _BASES.search(call.qualified) or (call.qualified.endswith("Node::make_shared"))
        if call.arguments and (plain or (call.name in _MAKERS and _BASES.search(template))):
            yield call.arguments[0]
    for node in code.written.get("new", ()):
        arguments = node.child_by_field_name("arguments")
        kind = "".join(code.text(node.child_by_field_name("type")).split())
        if arguments is not None and _BASES.search(kind):
            yield from _first(arguments)
    for node in code.written.get("declaration", ()):
        declarator = node.child_by_field_name("declarator")
        value = declarator.child_by_field_name("value") if declarator is not None else None
        kind = "".join(code.text(node.child_by_field_name("type")).split())
        if value is not None and value.type in ("argument_list", "initializer_list") and _BASES.search(kind):
            yield from _first(value)


def _first(arguments: Node) -> Iterator[Node]:
    yield from arguments.named_children[:1]
