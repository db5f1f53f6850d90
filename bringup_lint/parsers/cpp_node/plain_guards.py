"""Conditions of a C++ function that say nothing of what the object has lived through: they ask what came in, or whether
a device is open."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

DEPTH = 3
"""Local variables that are followed to what they are made of."""
_TELLS = regex(r"(?i)init|first|valid|ready|has_|received|started|set_?up|empty|size|count|calibrat|prev|last")
"""Words of conditions by which a function may know that it runs for the first time."""
_OPEN = regex(r"(?i)(?:is_?)?(?:open|connected|ok)(?:ed)?\Z")
_CONSTANT = regex(r"[A-Z][A-Z0-9_]*\Z|k[A-Z]\w*\Z")
_CHOOSES = frozenset(
    "if_statement while_statement do_statement switch_statement conditional_expression for_statement".split()
)
_SHORT = frozenset({"&&", "||", "and", "or"})
_KNOWN = ("qualified_identifier", "field_expression")
_ALWAYS, _NEVER = -1, sys.maxsize


class PlainGuards:
    """The conditions of one function, or lambda."""

    def __init__(self, code: Code, body: Node) -> None:
        self._code = code
        self._body = body
        self._made: dict[str, list[Node | None]] = {}
        """Local variable -> the values that it gets; None for one that is not known here."""
        self._own: dict[str, int] = {}
        """Member -> where the function itself has surely set it."""
        self._plain: dict[tuple[int | str, int], int] = {}
        """Condition or local variable, and how far it is followed -> behind which place it is plain."""
        self._read()

    def _read(self) -> None:
        stack = [self._body]
        while stack:
            node = stack.pop()
            stack += node.named_children
            if node.type in ("parameter_declaration", "optional_parameter_declaration", "catch_clause"):
                self._made.setdefault(self._declared(node), [])
            elif node.type == "declaration":
                self._read_declaration(node)
            elif node.type == "for_range_loop":
                self._made.setdefault(self._declared(node), []).append(node.child_by_field_name("right"))
            elif node.type == "assignment_expression":
                self._read_assignment(node)

    def _read_declaration(self, node: Node) -> None:
        is_static = any(each.type == "storage_class_specifier" for each in node.children)
        for each in node.children_by_field_name("declarator"):
            value = each.child_by_field_name("value") if each.type == "init_declarator" else None
            name = self._code.text(_innermost(each))
            known = self._made.setdefault(name, [])
            if is_static:
                known.append(None)
            elif value is not None:
                known.append(value)

    def _read_assignment(self, node: Node) -> None:
        left, outer = node.child_by_field_name("left"), node.parent
        name = self._code.text(left).removeprefix("this->")
        value = node.child_by_field_name("right")
        if name in self._made:
            self._made[name].append(value)
        block = outer.parent if outer is not None and outer.type == "expression_statement" else None
        if block is not None and block.parent is not None and block.parent.id == self._body.id:
            self._own[name] = min(node.start_byte, self._own.get(name, node.start_byte))

    def _declared(self, node: Node) -> str:
        declarator = node.child_by_field_name("declarator")
        return self._code.text(_innermost(declarator)) if declarator is not None else ""

    def reaches(self, node: Node) -> bool:
        """Whether only such conditions decide about a place of the function, none of them in a lambda of it."""
        inner = node
        for outer in self._code.above(node):
            if outer.id == self._body.id:
                return True
            if outer.type == "lambda_expression" or not self._lets(outer, inner):
                return False
            inner = outer
        return False

    def _lets(self, outer: Node, inner: Node) -> bool:
        if outer.type == "binary_expression":
            is_short = self._code.text(outer.child_by_field_name("operator")) in _SHORT
            left = outer.child_by_field_name("left")
            if not is_short or left is None or left.id == inner.id:
                return True
            return self._plain_behind(left, DEPTH) < left.start_byte
        condition = outer.child_by_field_name("condition") if outer.type in _CHOOSES else None
        if condition is None or condition.id == inner.id or outer.type == "for_statement":
            return True
        return self._plain_behind(condition, DEPTH) < outer.start_byte

    def _plain_behind(self, condition: Node, depth: int) -> int:
        """The place behind which a condition is plain, as the function has then set all that it asks for."""
        if not depth:
            return _NEVER
        asked = (condition.id, depth)
        if asked not in self._plain:
            self._plain[asked] = self._read_condition(condition, depth)
        return self._plain[asked]

    def _read_condition(self, condition: Node, depth: int) -> int:
        found = _ALWAYS if not _TELLS.search(self._code.text(condition)) else _NEVER
        stack = [condition]
        while stack and found < _NEVER:
            node = stack.pop()
            if node.type == "this" or node.type == "lambda_expression":
                return _NEVER
            if node.type == "identifier":
                found = max(found, self._of_name(self._code.text(node), depth))
            elif node.type == "call_expression":
                asked = self._asked_by(node, depth)
                if asked is None:
                    return _NEVER
                stack += (*asked, *node.children_by_field_name("arguments"))
            elif node.type == "field_expression":
                stack += (each for each in node.children_by_field_name("argument"))
            elif node.type != "qualified_identifier":
                stack += node.named_children
        return found

    def _of_name(self, name: str, depth: int) -> int:
        """The place behind which a variable or member is plain."""
        asked = (name, depth)
        if asked not in self._plain:
            values = self._made.get(name)
            if values is None:
                self._plain[asked] = _ALWAYS if _CONSTANT.match(name) else self._own.get(name, _NEVER)
            else:
                places = (_NEVER if each is None else self._plain_behind(each, depth - 1) for each in values)
                self._plain[asked] = max(places, default=_ALWAYS)
        return self._plain[asked]

    def _asked_by(self, node: Node, depth: int) -> list[Node] | None:
        """What a call asks, beside its arguments: nothing for ``std::abs(x)`` and the question whether a device is
        open, and the variable whose method it is; None for other calls."""
        function = node.child_by_field_name("function")
        if function is None or (function.type not in _KNOWN and depth == DEPTH):
            return None
        if function.type != "field_expression" or depth < DEPTH:  # what a value is made of
            return []
        name = self._code.text(function.child_by_field_name("field"))
        return [] if _OPEN.match(name) else function.children_by_field_name("argument") or None


def _innermost(declarator: Node) -> Node:
    """The name that a declarator declares."""
    for _ in range(8):
        inner = declarator.child_by_field_name("declarator")
        if inner is None and declarator.type == "reference_declarator" and declarator.named_child_count:
            inner = declarator.named_children[0]
        if inner is None:
            break
        declarator = inner
    return declarator
