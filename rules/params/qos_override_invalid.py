"""A QoS override has no effect, or stops the node.

## What it finds
Parameters under `qos_overrides` whose topic is not written with its full name, whose entity is neither `publisher`
nor `subscription`, or whose policy or value does not exist. Also, in launch files too, a topic of the library that is
misspelt, such as `/parameters_events`.

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
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import QOS_POLICIES
from bringup_lint.api.params import QOS_WORDS
from bringup_lint.api.params import OverrideProblem
from bringup_lint.api.params import ParameterFile
from bringup_lint.api.params import QosOverride
from bringup_lint.api.params import qos_overrides
from bringup_lint.api.spelling import nearest

OF_VALUE = (OverrideProblem.WORD, OverrideProblem.NUMBER, OverrideProblem.FLAG)
_LIBRARY = ("/parameter_events", "/tf_static", "/rosout")
"""Topics that the client library or tf2 makes, with names long enough to be recognised."""


@rule(
    "warning",
    symptoms=[
        "InvalidQosOverridesException",
        "Unexpected QoS override for policy",
    ],
)
def qos_override_invalid(robot: Robot) -> Iterator[Finding]:
    said: set[tuple[ParameterFile, str, str]] = set()
    for override in qos_overrides(robot.params):
        problem = override.problem
        if problem is None:
            continue
        message, advice = _described(override, problem)
        cause = (override.file, override.topic, message)
        if cause not in said:
            said.add(cause)
            where = override.parameter.span if problem in OF_VALUE else override.parameter.key
            yield finding(where, message, advice=advice)
    topics: dict[tuple[str, str], list[Located]] = {}
    meant = {}
    for place, topic, near in _misspelt(robot):
        topics.setdefault((place.span.path, topic), []).append(place)
        meant[topic] = near
    for (_, topic), places in topics.items():
        first, *others = dict.fromkeys(places)
        yield finding(
            first,
            f"No node has a topic {topic}: the override has no effect",
            advice=f"write {meant[topic]}",
            related=[note(each, "this one neither") for each in others[:10]],
        )


def _misspelt(robot: Robot) -> Iterator[tuple[Located, str, str]]:
    """The names of parameters that mean a topic of the library and misspell it: the name, the topic, the one meant."""
    for file, parameter in robot.params.parameters:
        if parameter.name.startswith("qos_overrides./") and file.source.judged:
            yield from _near(parameter.key, parameter.name)
    for node in robot.launch.nodes:
        for values in node.parameters:
            if not isinstance(values, launch.DictValue):
                continue
            for key, _ in values.items:
                name = launch.literal(key)
                if name is not None and name.span.source.judged:
                    yield from _near(name, str(name))


def _near(place: Located, name: str) -> Iterator[tuple[Located, str, str]]:
    topic = name.partition(".")[2].partition(".")[0] if name.startswith("qos_overrides./") else ""
    meant = nearest(topic, _LIBRARY, 1) if topic not in _LIBRARY else []
    if len(meant) == 1:
        yield place, topic, meant[0]


def _described(override: QosOverride, problem: OverrideProblem) -> tuple[str, str]:
    """The message and the advice."""
    policy = override.parts[-1]
    if problem is OverrideProblem.RELATIVE_TOPIC:
        return (
            f"The QoS override for '{override.topic}' is ignored: the topic needs its full name",
            "write it with its namespace and a leading /"
            + ("" if override.has_entity else ", and publisher or subscription between it and the policy")
            + (", and the value in small letters" if override.is_in_capitals else ""),
        )
    if problem is OverrideProblem.PARTS:
        near = nearest(override.parts[1], ("publisher", "subscription"), 4) if len(override.parts) == 3 else []
        needs = "it must be topic.publisher.policy or topic.subscription.policy"
        return (
            f"The QoS override '{override.name}' is ignored: {needs}",
            f"write {near[0]}" if near else "use these three parts",
        )
    if problem is OverrideProblem.POLICY:
        near = nearest(policy, QOS_POLICIES, 3)
        usual = "use history, depth, reliability, durability, deadline, lifespan or liveliness"
        return f"There is no QoS policy '{policy}': the override is ignored", f"write {near[0]}" if near else usual
    return _of_value(override, policy, problem)


def _of_value(override: QosOverride, policy: str, problem: OverrideProblem) -> tuple[str, str]:
    dies = "the node exits with an exception"
    if problem is OverrideProblem.WORD:
        return f"'{override.parameter.text}' is not a valid {policy}: {dies}", f"use {', '.join(QOS_WORDS[policy][:2])}"
    if problem is OverrideProblem.NUMBER:
        unit = "a number of messages" if policy == "depth" else "nanoseconds"
        return f"{policy} must be an integer ({unit}): {dies}", f"write {unit} as an integer"
    return f"{policy} must be true or false: {dies}", "write true or false"
