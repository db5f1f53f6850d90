"""Publishers, subscriptions, services, actions and timers of a C++ file, with their callbacks."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import Qos
from bringup_lint.model.node_source import Timer
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.qos import quality
from bringup_lint.parsers.cpp_node.syntax import FUNCTIONS
from bringup_lint.parsers.cpp_node.syntax import Call
from bringup_lint.parsers.cpp_node.syntax import Code
from bringup_lint.parsers.cpp_node.values import Names
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from tree_sitter import Node


class Shape(NamedTuple):
    """Where a call takes what: the positions of QoS and callback after the name, which comes first."""

    role: str
    qos: int | None = None
    callback: int | None = None


METHODS = {
    "create_publisher": Shape("publisher", 1),
    "create_subscription": Shape("subscription", 1, 2),
    "create_service": Shape("service", None, 1),
    "create_client": Shape("client"),
}
_ACTIONS = {"create_server": Shape("action-server", None, 3), "create_client": Shape("action-client")}
TIMERS = ("create_wall_timer", "create_timer")
_BOUND = regex(r"&\s*(?:\w+\s*::\s*)*(?P<name>\w+)\s*\Z")
_UNITS = {"nanoseconds": 1e-9, "microseconds": 1e-6, "milliseconds": 1e-3, "seconds": 1.0, "minutes": 60.0}
_SUFFIXES = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0, "min": 60.0, "h": 3600.0}
_DURATION = regex(r"(?:std::)?(?:chrono::)?(?P<unit>\w+)[({](?P<number>[\d.']+)[uUlLfF]*[)}]\Z")
_LITERAL = regex(r"(?P<number>[\d.']+)(?P<unit>ns|us|ms|s|min|h)\Z")
_CHANGED = regex(r"(?P<name>[A-Za-z_]\w*)\s*\.\s*\w+\s*\(")
"""A call on a variable."""
_READING = regex(r"\s*(?:\.|->)\s*(?:get_rmw_qos_profile|\w+\s*\(\s*\)\s*(?:==|!=))")
_LOOPS = frozenset({"for_statement", "for_range_loop", "while_statement", "do_statement"})
_SECONDS = regex(r"(?:std::)?(?:chrono::)?duration<(?:double|float)>[({](?P<number>[\d.]+)[fF]?[)}]\Z")


def endpoint(code: Code, names: Names, call: Call) -> tuple[Endpoint, Callback | None] | None:
    """What a call makes; None when it makes no endpoint."""
    shape = METHODS.get(call.name)
    given = call.arguments
    if call.qualified.startswith("rclcpp_action::"):
        shape = _ACTIONS.get(call.name)
    if shape is None or call.template is None:
        return None
    if call.qualified in (f"rclcpp::{call.name}", f"rclcpp_action::{call.name}"):
        given = given[1:]
    name, parameter = names.of_name(given[0]) if given else (None, None)
    callback = None
    if shape.callback is not None and len(given) > shape.callback:
        callback = callback_of(code, given[shape.callback], shape.role.replace("-server", ""))
    qos = profile(code, given[shape.qos]) if shape.qos is not None and len(given) > shape.qos else None
    made = Endpoint(
        shape.role,
        names.interface(call),
        name,
        parameter,
        qos,
        callback.name if callback is not None else None,
        None,
        code.kept(call.node),
        "Lifecycle" in code.source.text,
        code.span(call.node),
        code.is_conditional(call.node),
        code.function_name(call.node),
    )
    return made, callback


def timer(code: Code, call: Call) -> tuple[Timer, Callback | None] | None:
    """What ``create_wall_timer`` makes; ``rclcpp::create_timer`` takes node and clock first."""
    if call.name not in TIMERS or len(call.arguments) < 2:
        return None
    given = call.arguments[2:] if call.qualified == f"rclcpp::{call.name}" else call.arguments
    if len(given) < 2:
        return None
    callback = callback_of(code, given[1], "timer")
    made = Timer(
        seconds(code.text(given[0])),
        callback.name if callback is not None else None,
        code.kept(call.node),
        None,
        code.span(call.node),
        code.is_conditional(call.node),
        code.function_name(call.node),
    )
    return made, callback


def seconds(text: str) -> float | None:
    """A duration as C++ writes it, in seconds: ``100ms``, ``std::chrono::seconds(2)``."""
    text = "".join(text.split())
    found = _LITERAL.match(text)
    if found is not None:
        return _number(found["number"], _SUFFIXES[found["unit"]])
    found = _DURATION.match(text)
    if found is not None and found["unit"] in _UNITS:
        return _number(found["number"], _UNITS[found["unit"]])
    found = _SECONDS.match(text)
    return _number(found["number"], 1.0) if found is not None else None


def _number(text: str, unit: float) -> float | None:
    try:
        return float(text.replace("'", "")) * unit
    except ValueError:
        return None


def callback_of(code: Code, node: Node, role: str) -> Callback | None:
    """The method or lambda that is handed over; None when neither is written there."""
    span = code.span(node)
    if node.type == "lambda_expression":
        return Callback(role, None, span)
    text = code.text(node)
    if node.type == "call_expression":
        call = code.call(node)
        if call is None or call.name != "bind" or not call.arguments:
            return None
        text = code.text(call.arguments[0])
    found = _BOUND.match(text)
    return Callback(role, found["name"], span) if found is not None else None


def profile(code: Code, node: Node) -> Qos | None:
    """The quality of service of an argument: written there, or kept in a variable, also with what is called on it."""
    text = code.text(node)
    if node.type == "identifier":
        made = _variable(code, text, node)
        return quality(made, code.span(node)) if made is not None else None
    changed = _CHANGED.match(text) if node.type == "call_expression" else None
    made = _variable(code, changed["name"], node) if changed is not None else None
    if changed is not None and made is not None:
        return quality(made + text[changed.end("name") :], code.span(node))
    return quality(text, code.span(node))


def _variable(code: Code, name: str, use: Node) -> str | None:
    """The expression that makes the profile which a variable holds where it is used; None when that is not known."""
    scope = _scope(code, name, use)
    made = [node for node in code.written.get("declaration", ()) if _declares(code, node, name)]
    made = [node for node in made if code.body_of(node) == scope]
    fields = [node for node in code.written.get("field", ()) if scope is None and _is_field(code, node, name)]
    written = [
        node
        for node in code.written.get("assignment", ())
        if _is_in(node, scope) and re.match(rf"{re.escape(name)}\b", code.text(node.child_by_field_name("left")))
    ]
    changes = _changes(code, name, use, scope)
    if len(made) + len(fields) != 1 or changes is None or written:
        return None
    if fields:
        return code.text(fields[0].child_by_field_name("default_value"))
    declarator = made[0].child_by_field_name("declarator")
    value = declarator.child_by_field_name("value") if declarator is not None else None
    kind = code.text(made[0].child_by_field_name("type"))
    text = code.text(value)
    if value is not None and value.type in ("argument_list", "initializer_list"):
        text = f"{kind}{text}"
    return text + changes


def _scope(code: Code, name: str, use: Node) -> Node | None:
    """The innermost function around the use of a variable that declares it; None for one of the file or class."""
    word = re.compile(rf"\b{re.escape(name)}\b")
    for outer in code.above(use):
        if outer.type in FUNCTIONS:
            own = (node for node in code.written.get("declaration", ()) if _declares(code, node, name))
            if any(code.body_of(node) == outer for node in own):
                return outer
            if word.search(code.text(outer.child_by_field_name("declarator"))):
                return outer
    return None


def _is_in(node: Node, scope: Node | None) -> bool:
    return scope is None or (scope.start_byte <= node.start_byte and node.end_byte <= scope.end_byte)


def _changes(code: Code, name: str, use: Node, scope: Node | None) -> str | None:
    """What statements before the use of a local variable call on it, in the order of the text; None where one does so
    under a condition, or elsewhere."""
    found = []
    for node in code.written.get("call", ()):
        text = code.text(node)
        if not text.startswith((f"{name}.", f"{name}->")) or not _is_in(node, scope) or node == use:
            continue
        statement = node.parent
        if statement is not None and statement.type in ("field_expression", "call_expression"):
            continue  # a part of a chain, of which the whole is another call
        if _READING.match(text[len(name) :]):
            continue
        if scope is None or any(outer.type in _LOOPS for outer in code.above(use) if _is_in(outer, scope)):
            return None
        if node.start_byte > use.start_byte:
            continue
        if statement is None or statement.type != "expression_statement" or not _is_in(use, statement.parent):
            return None
        found.append(text[len(name) :])
    return "".join(found)


def _is_field(code: Code, node: Node, name: str) -> bool:
    value = node.child_by_field_name("default_value")
    return value is not None and code.text(node.child_by_field_name("declarator")) == name


def _declares(code: Code, node: Node, name: str) -> bool:
    declarator = node.child_by_field_name("declarator")
    if declarator is None or declarator.type != "init_declarator":
        return False
    kind = code.text(node.child_by_field_name("type"))
    return code.text(declarator.child_by_field_name("declarator")) == name and (kind == "auto" or kind.endswith("QoS"))
