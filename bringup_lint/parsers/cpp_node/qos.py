"""Quality of service as C++ sources write it: a number, a profile of rclcpp, and the calls that change it."""

from __future__ import annotations

import re

from bringup_lint.dataclass import replace
from bringup_lint.model.node_source import INFINITE
from bringup_lint.model.node_source import Qos
from bringup_lint.model.node_source import QosChange
from bringup_lint.pattern import regex
from bringup_lint.source import Span

_NUMBER = regex(r"\d+[uUlL]*\Z")
_PROFILE = regex(r"(?:rclcpp::)?(?P<name>\w*QoS)\s*[({](?P<inner>[^(){}]*(?:[({][^(){}]*[)}][^(){}]*)?)[)}]")
_CALL = regex(r"\.\s*(?P<name>\w+)\s*\((?P<inner>[^()]*)\)\s*")
_DEPTH = regex(r"(?:(?:rclcpp::)?KeepLast\s*[({]\s*)?(?P<depth>\d+)[uUlL]*\s*[)}]?\Z")
_PRESETS = {
    "SensorDataQoS": ("BEST_EFFORT", "VOLATILE", 5),
    "SystemDefaultsQoS": ("SYSTEM_DEFAULT", "SYSTEM_DEFAULT", None),
    "ServicesQoS": ("RELIABLE", "VOLATILE", 10),
    "ParametersQoS": ("RELIABLE", "VOLATILE", 1000),
    "ParameterEventsQoS": ("RELIABLE", "VOLATILE", 1000),
    "BestAvailableQoS": ("BEST_AVAILABLE", "BEST_AVAILABLE", None),
}
_RMW = {
    "sensor_data": ("BEST_EFFORT", "VOLATILE", 5),
    "default": ("RELIABLE", "VOLATILE", 10),
    "system_default": ("SYSTEM_DEFAULT", "SYSTEM_DEFAULT", None),
    "services_default": ("RELIABLE", "VOLATILE", 10),
    "parameters": ("RELIABLE", "VOLATILE", 1000),
}
"""The profiles of rmw that ``rclcpp::QoS`` takes as its second argument."""
_INITIAL = regex(r"(?:rclcpp::)?(?:KeepLast|KeepAll|QoSInitialization)\b")
_RMW_PROFILE = "rmw_qos_profile_"
_POLICIES = {
    "besteffort": "BEST_EFFORT",
    "reliable": "RELIABLE",
    "transientlocal": "TRANSIENT_LOCAL",
    "volatile": "VOLATILE",
    "systemdefault": "SYSTEM_DEFAULT",
}
"""The last words of the constants of rclcpp and rmw, without underscores."""
_POLICY = regex(
    r"(?:rclcpp::)?(?:Reliability|Durability)Policy::(?P<name>\w+)\Z"
    r"|RMW_QOS_POLICY_(?:RELIABILITY|DURABILITY)_(?P<constant>\w+)\Z"
)
_CHANGES: dict[str, QosChange] = {
    "reliable": {"reliability": "RELIABLE"},
    "best_effort": {"reliability": "BEST_EFFORT"},
    "reliability_best_available": {"reliability": "BEST_AVAILABLE"},
    "transient_local": {"durability": "TRANSIENT_LOCAL"},
    "durability_volatile": {"durability": "VOLATILE"},
    "durability_best_available": {"durability": "BEST_AVAILABLE"},
    "keep_all": {"history": "KEEP_ALL", "depth": None},
    "keep_last": {"history": "KEEP_LAST", "depth": None},
    "history": {"history": None, "depth": None},
    "reliability": {"reliability": None},
    "durability": {"durability": None},
    "deadline": {"deadline": None},
    "liveliness": {"liveliness": None},
    "liveliness_lease_duration": {"lease": None},
    "lifespan": {},
    "avoid_ros_namespace_conventions": {},
}


def quality(text: str, span: Span) -> Qos | None:
    """The profile that an expression makes; None when it is not understood."""
    text = text.strip()
    if _NUMBER.match(text):
        return _made(span, "RELIABLE", "VOLATILE", int(text.rstrip("uUlL")))
    profile = _PROFILE.match(text)
    if profile is None:
        return None
    found = _profile(profile["name"], profile["inner"].strip(), span)
    at = profile.end()
    while found is not None and text[at:].strip():
        call = _CALL.match(text, at)
        if call is None or call["name"] not in _CHANGES:
            return None
        found = replace(found, **_changed(call["name"], call["inner"].strip()))
        at = call.end()
    return found


def _changed(name: str, given: str) -> QosChange:
    """What a call changes; a constant of rclcpp or rmw says to what."""
    policy = _POLICY.match(given)
    if policy is not None and name in ("reliability", "durability"):
        value = _POLICIES.get((policy["name"] or policy["constant"]).replace("_", "").lower())
        return {"reliability": value} if name == "reliability" else {"durability": value}
    return _CHANGES[name]


def _profile(name: str, inner: str, span: Span) -> Qos | None:
    if name in _PRESETS:
        reliability, durability, depth = _PRESETS[name]
        number = _DEPTH.match(inner)
        return _made(span, reliability, durability, int(number["depth"]) if number else depth if not inner else None)
    if name != "QoS":
        return None
    number = _DEPTH.match(inner)
    if number:
        return _made(span, "RELIABLE", "VOLATILE", int(number["depth"]))
    _, _, last = inner.rpartition(",")
    if _INITIAL.match(inner) and last.strip().startswith(_RMW_PROFILE):
        known = _RMW.get(last.strip().removeprefix(_RMW_PROFILE))
        return _made(span, known[0], known[1], None) if known is not None else None
    if re.match(r"(?:rclcpp::)?KeepAll\s*[({]\s*[)}]\Z", inner):
        return replace(_made(span, "RELIABLE", "VOLATILE", None), history="KEEP_ALL")
    return None


def _made(span: Span, reliability: str, durability: str, depth: int | None) -> Qos:
    return Qos(
        span, reliability, durability, "KEEP_LAST", depth, deadline=INFINITE, liveliness="AUTOMATIC", lease=INFINITE
    )
