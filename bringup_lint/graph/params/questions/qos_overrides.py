"""Parameters ``qos_overrides.<topic>.<entity>.<policy>`` that rclcpp and rclpy ignore or refuse.

Source: rclcpp, ``qos_overriding_options.cpp`` and ``qos_parameters.hpp``; rclpy, ``qos_overriding_options.py``.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from typing import TYPE_CHECKING

from bringup_lint.model.params import Parameter
from bringup_lint.model.params import ParameterFile
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params

_BEST = ("system_default", "best_available")
WORDS = {
    "history": ("keep_last", "keep_all", "system_default"),
    "reliability": ("reliable", "best_effort", *_BEST),
    "durability": ("volatile", "transient_local", *_BEST),
    "liveliness": ("automatic", "manual_by_topic", *_BEST),
}
"""The policies whose values are words, with these words."""
NUMBERS = ("depth", "deadline", "lifespan", "liveliness_lease_duration")
"""The policies whose values are integers: a depth in messages, durations in nanoseconds."""
FLAG = "avoid_ros_namespace_conventions"
POLICIES = (*WORDS, *NUMBERS, FLAG)
_ENTITY = regex(r"(?:publisher|subscription)(?:_\w+)?\Z")


class OverrideProblem(Enum):
    RELATIVE_TOPIC = "the topic is not a full name"
    PARTS = "the name does not have the three parts"
    POLICY = "there is no such policy"
    WORD = "the policy has no such value"
    NUMBER = "the value is not an integer"
    FLAG = "the value is not a boolean"


class QosOverride(NamedTuple):
    """One parameter, by the parts of its name."""

    file: ParameterFile
    parameter: Parameter
    parts: tuple[str, ...]
    """Topic, entity and policy, where the name is as it has to be."""

    @property
    def topic(self) -> str:
        return self.parts[0]

    @property
    def name(self) -> str:
        return ".".join(self.parts)

    @property
    def has_entity(self) -> bool:
        """Whether it is for the publisher or the subscription of a topic."""
        return len(self.parts) == 3 and _ENTITY.match(self.parts[1]) is not None

    @property
    def is_in_capitals(self) -> bool:
        """Whether its value is a word that rclcpp knows in small letters only."""
        words, word = WORDS.get(self.parts[-1], ()), str(self.parameter.value.data)
        return word not in words and word.lower() in words

    @property
    def problem(self) -> OverrideProblem | None:
        if not self.topic.startswith("/"):
            return OverrideProblem.RELATIVE_TOPIC
        if not self.has_entity:
            return OverrideProblem.PARTS
        return _value_problem(self.parts[2], self.parameter)


def _value_problem(policy: str, parameter: Parameter) -> OverrideProblem | None:
    value = parameter.value
    if policy in WORDS:
        return None if str(value.data).lower() in WORDS[policy] else OverrideProblem.WORD
    if policy in NUMBERS:
        return None if value.type == "integer" else OverrideProblem.NUMBER
    if policy == FLAG:
        return None if value.type == "bool" else OverrideProblem.FLAG
    return OverrideProblem.POLICY


def qos_overrides(params: Params) -> Iterator[QosOverride]:
    """The overrides of all parameter files; those that a substitution completes are left out."""
    for file, parameter in params.parameters:
        first, *parts = parameter.name.split(".")
        if first == "qos_overrides" and parts and "$(" not in parameter.name + parameter.text:
            yield QosOverride(file, parameter, tuple(parts))
