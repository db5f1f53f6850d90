"""Quality of service profiles as node sources write them (``rclpy.qos``)."""

from __future__ import annotations

import ast
from typing import Any

from bringup_lint.dataclass import replace
from bringup_lint.model.node_source import INFINITE
from bringup_lint.model.node_source import Qos
from bringup_lint.model.node_source import with_policy
from bringup_lint.model.node_source import with_seconds
from bringup_lint.parsers.python_node.scopes import AttributeSet
from bringup_lint.parsers.python_node.scopes import Scope
from bringup_lint.parsers.python_node.values import Called
from bringup_lint.parsers.python_node.values import Symbol
from bringup_lint.parsers.python_node.values import Values
from bringup_lint.parsers.python_node.values import is_number
from bringup_lint.source import Span

Policies = tuple[str, str, str, int, str]
_DEFAULT: Policies = ("RELIABLE", "VOLATILE", "KEEP_LAST", 10, "SYSTEM_DEFAULT")
_SENSOR: Policies = ("BEST_EFFORT", "VOLATILE", "KEEP_LAST", 5, "SYSTEM_DEFAULT")
_PARAMETERS: Policies = ("RELIABLE", "VOLATILE", "KEEP_LAST", 1000, "SYSTEM_DEFAULT")
_STATUS: Policies = ("RELIABLE", "TRANSIENT_LOCAL", "KEEP_LAST", 1, "SYSTEM_DEFAULT")
_SYSTEM: Policies = ("SYSTEM_DEFAULT", "SYSTEM_DEFAULT", "SYSTEM_DEFAULT", 0, "SYSTEM_DEFAULT")
_AVAILABLE: Policies = ("BEST_AVAILABLE", "BEST_AVAILABLE", "KEEP_LAST", 10, "BEST_AVAILABLE")
PRESETS: dict[str, Policies] = {
    "qos_profile_default": _DEFAULT,
    "qos_profile_sensor_data": _SENSOR,
    "qos_profile_services_default": _DEFAULT,
    "qos_profile_parameters": _PARAMETERS,
    "qos_profile_parameter_events": _PARAMETERS,
    "qos_profile_action_status_default": _STATUS,
    "qos_profile_system_default": _SYSTEM,
    "qos_profile_best_available": _AVAILABLE,
}
"""The profiles of ``rclpy.qos`` (Jazzy): reliability, durability, history, depth, liveliness."""
PRESET_MEMBERS = {
    "DEFAULT": "qos_profile_default",
    "SENSOR_DATA": "qos_profile_sensor_data",
    "SERVICES_DEFAULT": "qos_profile_services_default",
    "PARAMETERS": "qos_profile_parameters",
    "PARAMETER_EVENTS": "qos_profile_parameter_events",
    "ACTION_STATUS_DEFAULT": "qos_profile_action_status_default",
    "SYSTEM_DEFAULT": "qos_profile_system_default",
    "BEST_AVAILABLE": "qos_profile_best_available",
}
_POLICIES = {
    "reliability": ("ReliabilityPolicy", {"RELIABLE", "BEST_EFFORT", "SYSTEM_DEFAULT", "BEST_AVAILABLE"}),
    "durability": ("DurabilityPolicy", {"TRANSIENT_LOCAL", "VOLATILE", "SYSTEM_DEFAULT", "BEST_AVAILABLE"}),
    "history": ("HistoryPolicy", {"KEEP_LAST", "KEEP_ALL", "SYSTEM_DEFAULT"}),
    "liveliness": ("LivelinessPolicy", {"AUTOMATIC", "MANUAL_BY_TOPIC", "SYSTEM_DEFAULT", "BEST_AVAILABLE"}),
}
_FIELDS = {"deadline": "deadline", "liveliness_lease_duration": "lease"}
_MODULES = ("rclpy.qos.", "rclpy.")
_NEVER = 9_223_372_036.0
"""Seconds; rclpy's infinite duration and what comes near."""


def qos_of(values: Values, node: ast.expr, scope: Scope) -> Qos | None:
    """The profile that an expression stands for when it is handed over; None when nothing of it is known."""
    value = values.of(node, scope)
    span = values.span(node)
    if isinstance(value, int) and not isinstance(value, bool):
        return of_depth(value, span)
    found: Qos | None = None
    if isinstance(value, Symbol):
        found = _preset(value.name, span)
    elif isinstance(value, Called):
        found = _profile(values, value)
    return None if found is None else _changed(values, found, node, scope)


def of_depth(depth: int, span: Span) -> Qos:
    """What rclpy makes of a number: the default profile with that depth."""
    return replace(_of_policies(_DEFAULT, span), depth=depth)


def _of_policies(policies: Policies, span: Span) -> Qos:
    reliability, durability, history, depth, liveliness = policies
    time = None if reliability == "BEST_AVAILABLE" else INFINITE
    return Qos(span, reliability, durability, history, depth, time, liveliness, time)


def _preset(name: str, span: Span) -> Qos | None:
    short = _of_rclpy(name)
    if short is None:
        return None
    for group in ("QoSPresetProfiles.", "QoSPresetProfile."):
        if short.startswith(group):
            short = PRESET_MEMBERS.get(short[len(group) :].removesuffix(".value"), "")
    return _of_policies(PRESETS[short], span) if short in PRESETS else None


def _of_rclpy(name: str) -> str | None:
    return next((name[len(prefix) :] for prefix in _MODULES if name.startswith(prefix)), None)


def _profile(values: Values, called: Called) -> Qos | None:
    if _of_rclpy(called.name) != "QoSProfile":
        return None
    call, values = called.call, called.values or values
    span = values.span(call)
    if call.args or any(each.arg is None for each in call.keywords):
        return Qos(span)
    result = replace(_of_policies(_DEFAULT, span))
    for each in call.keywords:
        result = _with(values, result, each.arg or "", each.value, called.scope)
    return result


def _with(values: Values, qos: Qos, name: str, node: ast.expr, scope: Scope) -> Qos:
    """The profile with one policy set; None for that policy when the value is not known."""
    value = values.of(node, scope)
    if name == "depth":
        return replace(qos, depth=value if isinstance(value, int) and not isinstance(value, bool) else None)
    if name in _FIELDS:
        return with_seconds(qos, _FIELDS[name], _seconds(values, value))
    if name not in _POLICIES:
        return qos
    kind, members = _POLICIES[name]
    member = None
    if isinstance(value, Symbol):
        short = _of_rclpy(value.name) or ""
        short = short.removeprefix("QoS")
        if short.startswith(f"{kind}."):
            member = short.rpartition(".")[2].upper()
            if member.startswith("RMW_QOS_POLICY_"):
                member = member.removeprefix(f"RMW_QOS_POLICY_{name.upper()}_")
    return with_policy(qos, name, member if member in members else None)


def _seconds(values: Values, value: Any) -> float | None:
    if isinstance(value, Symbol):
        return INFINITE if value.name.endswith("duration.Infinite") else None
    if not isinstance(value, Called) or value.name not in ("rclpy.duration.Duration", "rclpy.time.Duration"):
        return None
    total = 0.0
    for each in value.call.keywords:
        amount = (value.values or values).of(each.value, value.scope)
        if each.arg not in ("seconds", "nanoseconds") or not is_number(amount):
            return None
        total += amount if each.arg == "seconds" else amount / 1e9
    if value.call.args:
        return None
    return INFINITE if total <= 0 or total >= _NEVER else total


def _changed(values: Values, qos: Qos, use: ast.expr, scope: Scope) -> Qos:
    """The profile after ``profile.reliability = ...`` before its use; what may have happened is unknown."""
    sets, home = _sets(use, scope)
    for change in sets:
        if change.field not in _POLICIES and change.field not in _FIELDS and change.field != "depth":
            continue
        after = change.scope is scope and change.value.lineno > use.lineno
        if after and not change.conditional:
            continue
        if change.conditional or (home is not None and change.scope is not home):
            qos = _unknown(qos, change.field)
        else:
            qos = _with(values, qos, change.field, change.value, change.scope)
    return qos


def _unknown(qos: Qos, name: str) -> Qos:
    """The profile with one policy of which nothing is known."""
    if name == "depth":
        return replace(qos, depth=None)
    return with_seconds(qos, _FIELDS[name], None) if name in _FIELDS else with_policy(qos, name, None)


def _sets(use: ast.expr, scope: Scope) -> tuple[list[AttributeSet], Scope | None]:
    if isinstance(use, ast.Name):
        home = scope.binding(use.id) or scope
        return home.sets.get(use.id, []), home
    if scope.cls is None or not isinstance(use, ast.Attribute) or not isinstance(use.value, ast.Name):
        return [], None
    if use.value.id != scope.self_name:
        return [], None
    made = scope.cls.attributes.get(use.attr, [])
    return scope.cls.sets.get(use.attr, []), made[0][1] if len(made) == 1 else None
