"""Publishers, subscriptions, services, actions, timers and callbacks: what the calls of a node source make."""

from __future__ import annotations

import ast

from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import Group
from bringup_lint.model.node_source import Qos
from bringup_lint.model.node_source import Timer
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_node.qos import of_depth
from bringup_lint.parsers.python_node.qos import qos_of
from bringup_lint.parsers.python_node.scopes import Call
from bringup_lint.parsers.python_node.scopes import Scope
from bringup_lint.parsers.python_node.values import Called
from bringup_lint.parsers.python_node.values import Read
from bringup_lint.parsers.python_node.values import Symbol
from bringup_lint.parsers.python_node.values import Values
from bringup_lint.parsers.python_node.values import argument
from bringup_lint.source import Located
from bringup_lint.source import Span


class Shape(NamedTuple):
    """Where a call takes what: positions and keywords of type, name, QoS, callback and callback group."""

    role: str
    type: tuple[int, str]
    name: tuple[int, str]
    qos: tuple[int, str] | None = None
    callback: tuple[int, str] | None = None
    callback_role: str = ""
    default_depth: int | None = None


METHODS = {
    "create_publisher": Shape("publisher", (0, "msg_type"), (1, "topic"), (2, "qos_profile")),
    "create_lifecycle_publisher": Shape("publisher", (0, "msg_type"), (1, "topic"), (2, "qos_profile")),
    "create_subscription": Shape(
        "subscription", (0, "msg_type"), (1, "topic"), (3, "qos_profile"), (2, "callback"), "subscription"
    ),
    "create_client": Shape("client", (0, "srv_type"), (1, "srv_name")),
    "create_service": Shape("service", (0, "srv_type"), (1, "srv_name"), None, (2, "callback"), "service"),
}
"""Methods of ``rclpy.node.Node``; ``create_lifecycle_publisher`` of the lifecycle node."""

CLASSES = {
    "rclpy.action.ActionClient": Shape("action-client", (1, "action_type"), (2, "action_name")),
    "rclpy.action.client.ActionClient": Shape("action-client", (1, "action_type"), (2, "action_name")),
    "rclpy.action.ActionServer": Shape(
        "action-server", (1, "action_type"), (2, "action_name"), None, (3, "execute_callback"), "action"
    ),
    "rclpy.action.server.ActionServer": Shape(
        "action-server", (1, "action_type"), (2, "action_name"), None, (3, "execute_callback"), "action"
    ),
    "message_filters.Subscriber": Shape(
        "subscription", (1, "msg_type"), (2, "topic"), (3, "qos_profile"), default_depth=10
    ),
}
"""Classes that take the node as their first argument."""

BROADCASTERS = {
    "TransformBroadcaster": (("publisher", "/tf", "VOLATILE", 100),),
    "StaticTransformBroadcaster": (("publisher", "/tf_static", "TRANSIENT_LOCAL", 1),),
    "TransformListener": (
        ("subscription", "/tf", "VOLATILE", 100),
        ("subscription", "/tf_static", "TRANSIENT_LOCAL", 100),
    ),
}
"""What the classes of tf2_ros make (tf2_ros, Jazzy): role, topic, durability, depth."""

_STEPS = ("goal_callback", "handle_accepted_callback", "cancel_callback")
_ADDERS = {
    "add_on_set_parameters_callback": "parameters",
    "add_done_callback": "client",
    "registerCallback": "subscription",
}


class Made(NamedTuple):
    """What one call makes, and the expression that stands for its node."""

    owner: ast.expr | None
    endpoints: tuple[Endpoint, ...] = ()
    timers: tuple[Timer, ...] = ()
    callbacks: tuple[Callback, ...] = ()


def made_by(values: Values, call: Call) -> Made | None:
    """What a call makes; None when it makes nothing of a node."""
    function = call.node.func
    if isinstance(function, ast.Attribute):
        if function.attr in METHODS:
            return _endpoint(values, call, METHODS[function.attr], function.value, function.attr)
        if function.attr == "create_timer":
            return _timer(values, call, function.value)
        if function.attr in _ADDERS and call.node.args:
            owner = function.value if function.attr == "add_on_set_parameters_callback" else None
            return Made(owner, callbacks=_callbacks(values, call, call.node.args[0], _ADDERS[function.attr], None))
        if function.attr == "on_shutdown" and call.node.args and "context" in written(function.value):
            return Made(None, callbacks=_callbacks(values, call, call.node.args[0], "shutdown", None))
    name = values.qualified(function, call.scope)
    if name in CLASSES:
        return _endpoint(values, call, CLASSES[name], argument(call.node, 0, "node"), name)
    if name is not None and name.startswith("tf2_ros.") and name.rpartition(".")[2] in BROADCASTERS:
        return _broadcaster(values, call, name.rpartition(".")[2])
    return None


def _endpoint(values: Values, call: Call, shape: Shape, owner: ast.expr | None, called: str) -> Made:
    node, scope = call.node, call.scope
    name, parameter = _name(values, argument(node, *shape.name), scope)
    span = values.span(node)
    qos: Qos | None = None
    if shape.qos is not None:
        given = argument(node, shape.qos[0], shape.qos[1], "qos")
        if given is not None:
            qos = qos_of(values, given, scope)
        elif shape.default_depth is not None and not _open(node):
            qos = of_depth(shape.default_depth, span)
    group = _group(values, argument(node, 99, "callback_group"), scope)
    callback = argument(node, *shape.callback) if shape.callback else None
    callbacks = _callbacks(values, call, callback, shape.callback_role, group) if callback is not None else ()
    if shape.role == "action-server":
        for step in _STEPS:
            handed = argument(node, 99, step)
            if handed is not None:
                callbacks += _callbacks(values, call, handed, "action-step", group)
    endpoint = Endpoint(
        shape.role,
        interface(values, argument(node, *shape.type), scope),
        name,
        parameter,
        qos,
        callbacks[0].name if callbacks else None,
        group,
        _attribute(call.kept),
        called == "create_lifecycle_publisher",
        span,
        call.conditional,
        scope.label,
    )
    return Made(owner, (endpoint,), (), callbacks)


def _open(node: ast.Call) -> bool:
    return any(each.arg is None for each in node.keywords) or any(isinstance(each, ast.Starred) for each in node.args)


def _name(values: Values, node: ast.expr | None, scope: Scope) -> tuple[Located | None, Located | None]:
    """The name, and the parameter that gives it."""
    value = values.of(node, scope) if node is not None else None
    if isinstance(value, Read):
        return value.default if isinstance(value.default, Located) else None, value.name
    return value if isinstance(value, Located) else None, None


def interface(values: Values, node: ast.expr | None, scope: Scope) -> str | None:
    """``geometry_msgs/msg/Twist`` for an imported message, service or action."""
    value = values.of(node, scope) if node is not None else None
    parts = value.name.split(".") if isinstance(value, Symbol) else []
    if len(parts) == 4 and parts[2] == f"_{_snake(parts[3])}":
        parts = [parts[0], parts[1], parts[3]]
    return "/".join(parts) if len(parts) == 3 and parts[1] in ("msg", "srv", "action") else None


def _snake(name: str) -> str:
    return "".join(f"_{char.lower()}" if char.isupper() and at else char.lower() for at, char in enumerate(name))


def _attribute(kept: ast.expr | None) -> str | None:
    if isinstance(kept, ast.Name):
        return kept.id
    if isinstance(kept, ast.Attribute) and isinstance(kept.value, ast.Name):
        return f"{kept.value.id}.{kept.attr}"
    return None


def _group(values: Values, node: ast.expr | None, scope: Scope) -> Group | None:
    if node is None or (isinstance(node, ast.Constant) and node.value is None):
        return None
    value = values.of(node, scope)
    if isinstance(value, Called):
        kind = value.name.rpartition(".")[2]
        key = f"{value.call.lineno}:{value.call.col_offset}"
        return Group(key, kind == "ReentrantCallbackGroup" if kind.endswith("CallbackGroup") else None)
    return Group(written(node), None)


def _seconds(period: object) -> float | None:
    if isinstance(period, bool) or not isinstance(period, (int, float)):
        return None
    try:
        return float(period)
    except OverflowError:
        return None


def _timer(values: Values, call: Call, owner: ast.expr) -> Made:
    node, scope = call.node, call.scope
    given = argument(node, 0, "timer_period_sec")
    period = values.of(given, scope) if given is not None else None
    if isinstance(period, Read):
        period = period.default
    group = _group(values, argument(node, 2, "callback_group"), scope)
    callback = argument(node, 1, "callback")
    callbacks = _callbacks(values, call, callback, "timer", group) if callback is not None else ()
    timer = Timer(
        _seconds(period),
        callbacks[0].name if callbacks else None,
        _attribute(call.kept),
        group,
        values.span(node),
        call.conditional,
        scope.label,
    )
    return Made(owner, (), (timer,), callbacks)


def _callbacks(values: Values, call: Call, node: ast.expr, role: str, group: Group | None) -> tuple[Callback, ...]:
    span = values.span(node)
    if isinstance(node, ast.Call) and values.qualified(node.func, call.scope) == "functools.partial" and node.args:
        node = node.args[0]
    if isinstance(node, ast.Lambda):
        return (Callback(role, None, span, group, node),)
    if isinstance(node, ast.Name):
        return (Callback(role, node.id, span, group),)
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == call.scope.self_name:
        return (Callback(role, node.attr, span, group),)
    return (Callback(role, None, span, group),)


def _broadcaster(values: Values, call: Call, name: str) -> Made | None:
    owner = call.node.args[-1] if name == "TransformListener" and len(call.node.args) > 1 else None
    owner = owner or argument(call.node, 1 if name == "TransformListener" else 0, "node")
    span = values.span(call.node)
    plain = len(call.node.args) <= 2 and all(
        each.arg in ("node", "buffer", "spin_thread") for each in call.node.keywords
    )
    endpoints = tuple(
        Endpoint(
            role,
            "tf2_msgs/msg/TFMessage",
            Located(topic, span),
            None,
            _tf_qos(span, durability, depth) if plain else None,
            None,
            None,
            _attribute(call.kept),
            False,
            span,
            call.conditional,
            call.scope.label,
            implied=True,
        )
        for role, topic, durability, depth in BROADCASTERS[name]
    )
    return Made(owner, endpoints)


def _tf_qos(span: Span, durability: str, depth: int) -> Qos:
    infinite = float("inf")
    return Qos(span, "RELIABLE", durability, "KEEP_LAST", depth, infinite, "SYSTEM_DEFAULT", infinite)
