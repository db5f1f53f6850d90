"""The quality of service that an argument gives: written there, or kept in a variable of the file."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.model.node_source import Qos
from bringup_lint.parsers.cpp_node.qos import quality
from bringup_lint.parsers.cpp_node.syntax import FUNCTIONS
from bringup_lint.parsers.cpp_node.syntax import LOOPS
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

_CHANGED = regex(r"(?P<name>[A-Za-z_]\w*)\s*\.\s*\w+\s*\(")
"""A call on a variable."""
_CALLED_ON = regex(r"\w+(?=\.|->)")
_NAME = regex(r"\w+")
_READING = regex(r"\s*(?:\.|->)\s*(?:get_rmw_qos_profile|\w+\s*\(\s*\)\s*(?:==|!=))")
MOST = 100
"""Places of a file that may make or change a variable of one name, and are looked at."""


class Profiles:
    """Those of one file, whose variables are looked up by their names."""

    def __init__(self, code: Code) -> None:
        self.code = code

    def of(self, node: Node) -> Qos | None:
        """The profile of an argument, also with what is called on a variable; None when it is not known."""
        text = self.code.text(node)
        if node.type == "identifier":
            made = self._variable(text, node)
            return quality(made, self.code.span(node)) if made is not None else None
        changed = _CHANGED.match(text) if node.type == "call_expression" else None
        made = self._variable(changed["name"], node) if changed is not None else None
        if changed is not None and made is not None:
            return quality(made + text[changed.end("name") :], self.code.span(node))
        return quality(text, self.code.span(node))

    def _variable(self, name: str, use: Node) -> str | None:
        """The expression that makes the profile which a variable holds where it is used."""
        places = (self._declared, self._fields, self._assigned, self._called_on)
        if any(len(each.get(name, ())) > MOST for each in places):
            return None
        scope = self._scope(name, use)
        made = [node for node in self._declared.get(name, ()) if self.code.body_of(node) == scope]
        fields = self._fields.get(name, []) if scope is None else []
        is_written = any(_is_in(node, scope) for node in self._assigned.get(name, ()))
        changes = self._changes(name, use, scope)
        if len(made) + len(fields) != 1 or changes is None or is_written:
            return None
        if fields:
            return self.code.text(fields[0].child_by_field_name("default_value"))
        declarator = made[0].child_by_field_name("declarator")
        value = declarator.child_by_field_name("value") if declarator is not None else None
        text = self.code.text(value)
        if value is not None and value.type in ("argument_list", "initializer_list"):
            text = f"{self.code.text(made[0].child_by_field_name('type'))}{text}"
        return text + changes

    def _scope(self, name: str, use: Node) -> Node | None:
        """The innermost function around the use of a variable that declares it; None for one of the file or class."""
        for outer in self.code.above(use):
            if outer.type in FUNCTIONS:
                if any(self.code.body_of(node) == outer for node in self._declared.get(name, ())):
                    return outer
                if name in _NAME.findall(self.code.text(outer.child_by_field_name("declarator"))):
                    return outer
        return None

    def _changes(self, name: str, use: Node, scope: Node | None) -> str | None:
        """What statements before the use of a local variable call on it, in the order of the text; None where one does
        so under a condition, or elsewhere."""
        found = []
        for node in self._called_on.get(name, ()):
            if not _is_in(node, scope) or node == use:
                continue
            statement = node.parent
            if statement is not None and statement.type in ("field_expression", "call_expression"):
                continue  # a part of a chain, of which the whole is another call
            call = self.code.text(node)[len(name) :]
            if _READING.match(call):
                continue
            if scope is None or any(outer.type in LOOPS for outer in self.code.above(use) if _is_in(outer, scope)):
                return None
            if node.start_byte > use.start_byte:
                continue
            if statement is None or statement.type != "expression_statement" or not _is_in(use, statement.parent):
                return None
            found.append(call)
        return "".join(found)

    @cached_property
    def _declared(self) -> dict[str, list[Node]]:
        """Variables that are made with a profile, or with what ``auto`` may stand for."""
        return self._by_name("declaration", self._declared_name)

    @cached_property
    def _fields(self) -> dict[str, list[Node]]:
        """Members with a default value."""
        return self._by_name("field", self._field_name)

    @cached_property
    def _assigned(self) -> dict[str, list[Node]]:
        """Assignments to a variable or to a part of it."""
        return self._by_name("assignment", lambda node: self._start(_NAME, node.child_by_field_name("left")))

    @cached_property
    def _called_on(self) -> dict[str, list[Node]]:
        """Calls on a variable or on what it points to."""
        return self._by_name("call", lambda node: self._start(_CALLED_ON, node))

    def _by_name(self, kind: str, name_of: Callable[[Node], str | None]) -> dict[str, list[Node]]:
        found: dict[str, list[Node]] = {}
        for node in self.code.written.get(kind, ()):
            name = name_of(node)
            if name is not None:
                found.setdefault(name, []).append(node)
        return found

    def _declared_name(self, node: Node) -> str | None:
        declarator = node.child_by_field_name("declarator")
        if declarator is None or declarator.type != "init_declarator":
            return None
        kind = self.code.text(node.child_by_field_name("type"))
        is_profile = kind == "auto" or kind.endswith("QoS")
        return self.code.text(declarator.child_by_field_name("declarator")) if is_profile else None

    def _field_name(self, node: Node) -> str | None:
        has_value = node.child_by_field_name("default_value") is not None
        return self.code.text(node.child_by_field_name("declarator")) if has_value else None

    def _start(self, pattern: re.Pattern[str], node: Node | None) -> str | None:
        found = pattern.match(self.code.text(node))
        return found[0] if found is not None else None


def _is_in(node: Node, scope: Node | None) -> bool:
    return scope is None or (scope.start_byte <= node.start_byte and node.end_byte <= scope.end_byte)
