"""Publishers, subscriptions, services, actions and timers of a C++ file, with their callbacks."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import Timer
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cpp_node.profiles import Profiles
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
_SECONDS = regex(r"(?:std::)?(?:chrono::)?duration<(?:double|float)>[({](?P<number>[\d.]+)[fF]?[)}]\Z")


def endpoint(code: Code, names: Names, profiles: Profiles, call: Call) -> tuple[Endpoint, Callback | None] | None:
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
    qos = profiles.of(given[shape.qos]) if shape.qos is not None and len(given) > shape.qos else None
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
