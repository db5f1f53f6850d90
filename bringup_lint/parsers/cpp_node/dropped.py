"""Subscriptions, services, timers and callback groups of a C++ file that nothing keeps: rclcpp holds them only by weak
pointers."""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import Dropped
from bringup_lint.named_tuple import NamedTuple
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
"""What takes a callback group, and does not keep it."""
_TYPED = frozenset({_SUBSCRIPTION, "service", "action server"})
"""Made by templates, to which the type of the interface is given."""
_OWNER = regex(r"(?:this->|(?:rclcpp|rclcpp_action)::|\w{0,40}(?i:node)\w{0,40}(?:\(\))?(?:->|\.))?create_\w+\Z")
_LASTS = regex(r"\b(?:spin|sleep|wait|join|while|get\s{0,4}\()")
"""Words of functions that go on while the executor runs."""
_STRING = regex(r'"[^"\n]*"')
_WORD = regex(r"\w+")


def dropped(code: Code) -> Iterator[Dropped]:
    """Those whose pointer is thrown away, or kept in a variable that nothing else uses before its function returns."""
    own = {(code.defined_name(each) or "").rpartition("::")[2] for each in code.written.get("function", ())}
    bodies = _Bodies(code)
    for call in code.calls:
        kind, least = _MADE.get(call.name, ("", 0))
        is_made = kind and len(call.arguments) >= least and call.name not in own and _OWNER.match(call.qualified)
        if not is_made or (kind in _TYPED and call.template is None) or _does_nothing(call):
            continue
        variable = _variable(code, call)
        if variable is None and (kind == _GROUP or not _is_statement(call.node)):
            continue
        if variable is None or _ends_unused(code, bodies, call, kind, variable):
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


def _ends_unused(code: Code, bodies: _Bodies, call: Call, kind: str, variable: str) -> bool:
    """Whether a function names a variable only once, or only gives a local callback group to what makes timers,
    services and clients, which hold no pointer to it; and returns before an executor can run. Subscriptions keep the
    options that they are made with."""
    node = code.body_of(call.node)
    if node is None or code.function_name(call.node) in (None, "main"):
        return False
    body = bodies.of(node)
    given = body.given[variable] if kind == _GROUP else 0
    if body.words[variable] != 1 + given or (kind == _GROUP and not given):
        return False
    return body.lasts == len(_LASTS.findall(_STRING.sub('""', code.text(call.node))))


class _Body(NamedTuple):
    words: Counter[str]
    given: Counter[str]
    """The arguments of what holds no pointer to a callback group."""
    lasts: int
    """How many words say that the function goes on."""


class _Bodies:
    """The functions of a file, each read once."""

    def __init__(self, code: Code) -> None:
        self._code = code
        self._known: dict[int, _Body] = {}
        self._makers = sorted(
            (call.node.start_byte, at) for at, call in enumerate(code.calls) if call.name in _HOLD_NO_GROUP
        )

    def of(self, node: Node) -> _Body:
        if node.id not in self._known:
            text = _STRING.sub('""', self._code.text(node))
            ends = (bisect_left(self._makers, (end, 0)) for end in (node.start_byte, node.end_byte))
            makers = (self._code.calls[at] for _, at in self._makers[slice(*ends)])
            given = Counter(self._code.text(argument) for each in makers for argument in each.arguments)
            self._known[node.id] = _Body(Counter(_WORD.findall(text)), given, len(_LASTS.findall(text)))
        return self._known[node.id]


def _does_nothing(call: Call) -> bool:
    """Whether the callback is empty, so that only the making counts: ``create_wall_timer(1s, [] {})``."""
    body = call.arguments[-1].child_by_field_name("body") if call.arguments else None
    return body is not None and all(each.type == "comment" for each in body.named_children)
