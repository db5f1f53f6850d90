"""Subscriptions, services, timers and callback groups of a C++ file that nothing keeps: rclcpp holds them only by weak
pointers."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Dropped
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node

_SUBSCRIPTION = "subscription"
_GROUP = "callback group"
_MADE = {
    "create_subscription": (_SUBSCRIPTION, 3),
    "create_service": ("service", 2),
    "create_wall_timer": ("timer", 2),
    "create_timer": ("timer", 2),
    "create_server": ("action server", 4),
    "create_callback_group": (_GROUP, 1),
}
"""What a call makes, and the fewest arguments that it takes."""
_HOLD_NO_GROUP = frozenset({"create_wall_timer", "create_timer", "create_service", "create_client"})
_TYPED = frozenset({_SUBSCRIPTION, "service", "action server"})
"""Made by templates, to which the type of the interface is given."""
_OWNER = regex(r"(?:this->|(?:rclcpp|rclcpp_action)::|\w{0,40}(?i:node)\w{0,40}(?:\(\))?(?:->|\.))?create_\w+\Z")
_LASTS = regex(r"\b(?:spin|sleep|wait|join|while|get\s{0,4}\()")
"""Words of functions that go on while the executor runs."""
_STRING = regex(r'"[^"\n]*"')


def dropped(code: Code) -> Iterator[Dropped]:
    """Those whose pointer is thrown away, or kept in a variable that nothing else uses before its function returns."""
    own = {(code.defined_name(each) or "").rpartition("::")[2] for each in code.written.get("function", ())}
    for call in code.calls:
        kind, least = _MADE.get(call.name, ("", 0))
        is_made = kind and len(call.arguments) >= least and call.name not in own and _OWNER.match(call.qualified)
        if not is_made or (kind in _TYPED and call.template is None) or _does_nothing(call):
            continue
        variable = _variable(code, call)
        if variable is None and (kind == _GROUP or not _is_statement(call.node)):
            continue
        if variable is None or _ends_unused(code, call, variable):
            yield Dropped(code.span(call.node), kind, variable)


def _is_statement(node: Node) -> bool:
    return node.parent is not None and node.parent.type == "expression_statement"


def _variable(code: Code, call: Call) -> str | None:
    """The local variable that a call initialises, when it is not static."""
    made = call.node.parent
    if made is None or made.type != "init_declarator" or made.parent is None or made.parent.type != "declaration":
        return None
    declarator = made.child_by_field_name("declarator")
    is_plain = declarator is not None and declarator.type == "identifier"
    is_static = any(each.type == "storage_class_specifier" for each in made.parent.children)
    return code.text(declarator) if is_plain and not is_static else None


def _ends_unused(code: Code, call: Call, variable: str) -> bool:
    """Whether a function names a variable only once, or hands a callback group on to what holds no pointer to it, and
    returns before an executor can run."""
    body = code.body_of(call.node)
    if body is None or code.function_name(call.node) in (None, "main"):
        return False
    text = _STRING.sub('""', code.text(body))
    rest = text.replace(_STRING.sub('""', code.text(call.node)), "", 1)
    if call.name == "create_callback_group":
        is_lost = _is_handed_on(code, body, text, variable)
    else:
        is_lost = len(re.findall(rf"\b{re.escape(variable)}\b", text)) == 1
    return is_lost and not _LASTS.search(rest)


def _is_handed_on(code: Code, body: Node, text: str, name: str) -> bool:
    """Whether a function only gives a local callback group to what makes timers, services and clients, which hold no
    pointer to it; subscriptions keep the options that they are made with."""
    inside = (each for each in code.calls if body.start_byte <= each.node.start_byte < body.end_byte)
    makers = (each for each in inside if each.name in _HOLD_NO_GROUP)
    given = sum(code.text(argument) == name for each in makers for argument in each.arguments)
    return given > 0 and len(re.findall(rf"\b{re.escape(name)}\b", text)) == 1 + given


def _does_nothing(call: Call) -> bool:
    """Whether the callback is empty, so that only the making counts: ``create_wall_timer(1s, [] {})``."""
    body = call.arguments[-1].child_by_field_name("body") if call.arguments else None
    return body is not None and all(each.type == "comment" for each in body.named_children)
