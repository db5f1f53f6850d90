"""A QoS override has no effect, or stops the node.

## What it finds
Parameters under `qos_overrides` whose topic is not written with its full name, whose entity is neither `publisher`
nor `subscription`, or whose policy or value does not exist.

## Why it matters on a robot
A wrong name is ignored without a message, and the topic keeps the policy of the code. A wrong value stops the node.

## Bad
```yaml
detector:
  ros__parameters:
    qos_overrides:
      scan:
        subscription:
          reliability: best_effort
```

## Good
```yaml
detector:
  ros__parameters:
    qos_overrides:
      /scan:
        subscription:
          reliability: best_effort
```

## When to ignore it
When the node reads the parameters below `qos_overrides` itself. rcl does not apply the reported ones.

## References
- rclcpp, `QosOverridingOptions`
- rclpy, `qos_overriding_options`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.params import Parameter
from bringup_lint.api.params import ParameterFile
from bringup_lint.api.spelling import nearest

_ENTITY = regex(r"(?:publisher|subscription)(?:_\w+)?\Z")
_BEST = ("system_default", "best_available")
_WORDS = {
    "history": ("keep_last", "keep_all", "system_default"),
    "reliability": ("reliable", "best_effort", *_BEST),
    "durability": ("volatile", "transient_local", *_BEST),
    "liveliness": ("automatic", "manual_by_topic", *_BEST),
}
_NUMBERS = ("depth", "deadline", "lifespan", "liveliness_lease_duration")
_FLAG = "avoid_ros_namespace_conventions"


@rule("warning", symptoms=["InvalidQosOverridesException"])
def qos_override_invalid(robot: Robot) -> Iterator[Finding]:
    said: set[tuple[ParameterFile, str, str]] = set()
    for file, parameter in robot.params.parameters:
        parts = parameter.name.split(".")
        if parts[0] != "qos_overrides" or len(parts) < 2 or "$(" in parameter.name + parameter.text:
            continue
        message, advice, where = _wrong(parts[1:], parameter)
        cause = (file, parts[1], message)
        if message and cause not in said:
            said.add(cause)
            yield finding(where, message, advice=advice)


def _wrong(parts: list[str], parameter: Parameter) -> tuple[str, str, Located] | tuple[str, str, Span]:
    name = parameter.name.removeprefix("qos_overrides.")
    key, value = parameter.key, parameter.value
    topic = parts[0]
    if not topic.startswith("/"):
        return (
            f"The QoS override for '{topic}' is ignored: the topic needs its full name",
            "write it with its namespace and a leading /",
            key,
        )
    if len(parts) != 3 or not _ENTITY.match(parts[1]):
        near = nearest(parts[1], ("publisher", "subscription"), 4) if len(parts) == 3 else []
        return (
            f"The QoS override '{name}' is ignored: it must be topic.publisher.policy or topic.subscription.policy",
            f"write {near[0]}" if near else "use these three parts",
            key,
        )
    policy = parts[2]
    if policy not in (*_WORDS, *_NUMBERS, _FLAG):
        near = nearest(policy, (*_WORDS, *_NUMBERS, _FLAG), 3)
        return (
            f"There is no QoS policy '{policy}': the override is ignored",
            f"write {near[0]}"
            if near
            else "use history, depth, reliability, durability, deadline, lifespan or liveliness",
            key,
        )
    if policy in _WORDS and str(value.data).lower() not in _WORDS[policy]:
        return (
            f"'{parameter.text}' is not a valid {policy}: the node exits with an exception",
            f"use {', '.join(_WORDS[policy][:2])}",
            parameter.span,
        )
    if policy in _NUMBERS and value.type != "integer":
        unit = "a number of messages" if policy == "depth" else "nanoseconds"
        return (
            f"{policy} must be an integer ({unit}): the node exits with an exception",
            f"write {unit} as an integer",
            parameter.span,
        )
    if policy == _FLAG and value.type != "bool":
        return (
            f"{policy} must be true or false: the node exits with an exception",
            "write true or false",
            parameter.span,
        )
    return "", "", key
