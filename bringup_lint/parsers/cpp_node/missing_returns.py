"""Functions of a C++ file that have a type and whose end is reached without a ``return``."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import MissingReturn
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.syntax import LOOPS
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

NESTED = 60
"""Statements inside one another that are followed."""
_TYPES = frozenset(
    {"primitive_type", "type_identifier", "qualified_identifier", "template_type", "sized_type_specifier"}
)
_NO_NAMES = frozenset({"main", "if", "for", "while", "switch", "catch"})
_DECLARATORS = ("pointer_declarator", "reference_declarator")
_MACRO = regex(r"[A-Z][A-Z0-9_]*\Z")
_LEAVES = frozenset({"return_statement", "throw_statement", "continue_statement"})
_UNFOLLOWED = regex(
    r"g(?<!\wg)oto\b|c(?<!\wc)o(?:_(?:return|await|yield)|nstexpr)\b|_(?<!\w_)(?:_?asm|_builtin_unreachable\b)"
    r"|n(?<!\wn)oreturn\b"
)
"""Words of bodies whose ways are not followed. Each way begins with a letter: the search goes from one to the next."""
_DIRECTIVE = regex(r"^[ \t]*#", re.M, hints="#")
_FOREVER = ("true", "1", "")
_ENDS = regex(
    r"(?i)abort|assert|die|exec|exit|fail|fatal|halt|jump|jmp|panic|quit|raise|reboot|reset|restart|terminate|throw"
    r"|unreachable|error"
)
"""Words of functions that may never return."""
_METHOD_ENDS = regex(r"(?i)abort|exit|fatal|panic|quit|reboot|restart|terminate|throw")
"""The same of methods: ``pointer.reset()`` returns."""
_LOGS = regex(r"(?:RCLCPP|RCUTILS|ROS|SPDLOG|QT|RC)_?[A-Z]{0,12}(?:CHECK|DEBUG|INFO|WARN|ERROR|FATAL|LOG)")
"""Macros after which the program goes on."""
_GIVEN = regex(r"(?i)\benable_if|\bdecltype\b|\bvoid_t\b|\btypename\b")

_UNMET = "when no condition of these holds"
"""It may be that one always does."""
_NOT_NULL = regex(r"!=\s{0,4}(?:nullptr|NULL)\b|\A\(\s{0,4}\w{1,80}(?:ptr|pointer)?_?\s{0,4}\)\Z")


class Way(NamedTuple):
    """How a statement may be left."""

    ends: bool
    """What follows it may run."""
    breaks: bool = False
    """It may leave the loop or ``switch`` that it is in."""


_STOPS = Way(False)
_GOES_ON = Way(True)


def missing_returns(code: Code) -> Iterator[MissingReturn]:
    for function in code.written.get("function", ()):
        name, body = _name(code, function), function.child_by_field_name("body")
        if name is None or body is None or body.type != "compound_statement" or not _owes_value(code, function):
            continue
        text = code.text(function)
        if _UNFOLLOWED.search(text) or _DIRECTIVE.search(text) or function.has_error:
            continue
        if not _block(code, _statements(body), 0).ends:
            continue
        last = next(reversed(_statements(body)), None)
        when = _when(code, last) if last is not None and _returns(body) else ""
        left = code.span(last) if last is not None and when else None
        is_open = when == _UNMET or _is_base(code, function)
        yield MissingReturn(code.span(name), code.text(name), when, left, is_open)


def _name(code: Code, function: Node) -> Node | None:
    """The last name of a function with a type; None for ``main``, for operators, and for statements that follow an
    error of the grammar: ``else if (...) {}``."""
    declarator = function.child_by_field_name("declarator")
    while declarator is not None and declarator.type in _DECLARATORS:
        declarator = next(iter(reversed(declarator.named_children)), None)
    if declarator is None or declarator.type != "function_declarator":
        return None
    name = declarator.child_by_field_name("declarator")
    while name is not None and name.type == "qualified_identifier":
        name = name.child_by_field_name("name")
    is_name = name is not None and name.type in ("identifier", "field_identifier")
    return name if is_name and code.text(name) not in _NO_NAMES else None


def _is_base(code: Code, function: Node) -> bool:
    """Whether a class that builds on this one may have a function of its own instead."""
    return "virtual" in [code.text(each) for each in function.children] and "override" not in code.text(
        function.child_by_field_name("declarator")
    )


def _owes_value(code: Code, function: Node) -> bool:
    """Whether the type of a function is surely not ``void``."""
    written = function.child_by_field_name("type")
    if written is None or written.type not in _TYPES:
        return False
    text = code.text(written)
    is_pointer = getattr(function.child_by_field_name("declarator"), "type", "") in _DECLARATORS
    if (text == "void" and not is_pointer) or _MACRO.match(text) or _GIVEN.search(text):
        return False
    return written.type == "primitive_type" or not any(
        outer.type == "template_declaration" for outer in code.above(function)
    )


def _statements(block: Node) -> list[Node]:
    return [each for each in block.named_children if each.type != "comment"]


def _block(code: Code, statements: list[Node], depth: int) -> Way:
    """The ways through statements one after the other."""
    breaks = False
    for each in statements:
        way = _way(code, each, depth)
        breaks |= way.breaks
        if not way.ends:
            return Way(False, breaks)
    return Way(True, breaks)


def _way(code: Code, node: Node, depth: int) -> Way:
    """A way that is not surely open counts as closed."""
    if depth > NESTED or node.type in _LEAVES:
        return _STOPS
    match node.type:
        case "break_statement":
            return Way(False, True)
        case "compound_statement":
            return _block(code, _statements(node), depth + 1)
        case "if_statement":
            return _branches(code, node, depth + 1)
        case "try_statement":
            return _try(code, node, depth + 1)
        case "switch_statement":
            return _switch(code, node, depth + 1)
        case "expression_statement":
            return _expression(code, node)
        case "labeled_statement" | "case_statement" | "attributed_statement":
            return _STOPS
    return _loop(code, node, depth + 1) if node.type in LOOPS else _GOES_ON


def _branches(code: Code, node: Node, depth: int) -> Way:
    """``if ... else if ... else``, which a loop follows as it may have any number of links."""
    ends = breaks = False
    current: Node | None = node
    while current is not None and current.type == "if_statement":
        chosen = current.child_by_field_name("consequence")
        way = _way(code, chosen, depth) if chosen is not None else _GOES_ON
        ends, breaks = ends or way.ends, breaks or way.breaks
        other = current.child_by_field_name("alternative")
        current = next(iter(_statements(other)), None) if other is not None else None
        if other is None:
            return Way(True, breaks)
    way = _way(code, current, depth) if current is not None else _GOES_ON
    return Way(ends or way.ends, breaks or way.breaks)


def _try(code: Code, node: Node, depth: int) -> Way:
    bodies = [node.child_by_field_name("body")]
    bodies += [each.child_by_field_name("body") for each in node.named_children if each.type == "catch_clause"]
    ways = [_block(code, _statements(each), depth) for each in bodies if each is not None]
    return Way(any(way.ends for way in ways), any(way.breaks for way in ways))


def _switch(code: Code, node: Node, depth: int) -> Way:
    """One without ``default`` may have all values of an enumeration, so that it is left by its breaks alone."""
    body = node.child_by_field_name("body")
    if body is None:
        return _STOPS
    ends, last = False, False
    for case in _statements(body):
        value = case.child_by_field_name("value")
        statements = [each for each in _statements(case) if value is None or each.id != value.id]
        way = _block(code, statements, depth)
        ends |= way.breaks
        last = way.ends
    return Way(ends or last)


def _loop(code: Code, node: Node, depth: int) -> Way:
    body = node.child_by_field_name("body")
    condition = "".join(code.text(node.child_by_field_name("condition")).split())
    is_endless = node.type != "for_range_loop" and condition.removeprefix("(").removesuffix(")") in _FOREVER
    return Way(body is not None and _way(code, body, depth).breaks) if is_endless else _GOES_ON


def _expression(code: Code, node: Node) -> Way:
    """A call that may never return, or a macro that may hold anything, closes the way."""
    call = next(iter(node.named_children), None)
    function = call.child_by_field_name("function") if call is not None and call.type == "call_expression" else None
    if function is None:
        return _GOES_ON if call is None or call.type != "identifier" else _STOPS
    name = code.text(function)
    if _LOGS.match(name):
        return _GOES_ON
    ends = _METHOD_ENDS if function.type == "field_expression" else _ENDS
    return _STOPS if _MACRO.match(name) or ends.search(name) else _GOES_ON


def _when(code: Code, last: Node) -> str:
    """When the last statement of a body that returns elsewhere is left at its end; empty: always."""
    if last.type in LOOPS:
        return "after this loop"
    if last.type == "if_statement":
        return _when_unmet(code, last)
    return {"switch_statement": "after a break of this switch", "try_statement": "after an exception"}.get(
        last.type, ""
    )


def _when_unmet(code: Code, choice: Node) -> str:
    """Conditions one after the other may be all that there are, and a pointer may never be null."""
    before, current = choice.prev_named_sibling, choice
    is_alone = before is None or before.type != "if_statement"
    for _ in range(NESTED):
        other = current.child_by_field_name("alternative")
        if other is None:
            is_alone &= current.id == choice.id
            is_possible = is_alone and not _NOT_NULL.search(code.text(current.child_by_field_name("condition")))
            return "when the condition of this if is false" if is_possible else _UNMET
        current = _statements(other)[0]
        if current.type != "if_statement":
            return "after a branch of this if"
    return _UNMET


def _returns(body: Node) -> bool:
    """Whether a body holds a ``return`` of its own."""
    stack = [body]
    while stack:
        current = stack.pop()
        if current.type == "return_statement":
            return True
        if current.type != "lambda_expression":
            stack += current.named_children
    return False
