"""Inputs of twist_mux that nobody feeds, beside a velocity of the same name that nobody takes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.resolved.endpoint_use import Pair
from bringup_lint.graph.topics.resolved.endpoint_use import Running
from bringup_lint.graph.topics.resolved.endpoint_use import Use

if TYPE_CHECKING:
    from bringup_lint.graph.topics.topics import Topics

_MUX = "twist_mux"
_COMMON = frozenset("cmd vel velocity twist command".split())
"""Words that say of any velocity that it is one."""


def unfed_inputs(topics: Topics, said: set[str]) -> Iterator[Pair]:
    """Each input with the velocity that is meant for it: a launch file remaps one, nothing of the robot takes it, and
    both have the same words but for those that all velocities have. No other file mentions either name.

    ``said``: topics to leave out.
    """
    seen = set()
    for running in topics.runs:
        if running.simulated:
            continue
        inputs, velocities = _one_sided(running)
        for use in inputs:
            meant = [each for each in velocities if _is_alike(each, use)]
            rivals = [each for each in inputs if meant and _is_alike(meant[0], each)]
            if len(meant) != 1 or len(rivals) != 1 or use.given in seen or use.topic in said:
                continue
            seen.add(use.given)
            if not any(_is_mentioned(topics, each) for each in (use, meant[0])):
                yield Pair(meant[0], use)


def _one_sided(running: Running) -> tuple[list[Use], list[Use]]:
    """The inputs that nobody feeds, and the remapped velocities that nobody takes."""
    inputs: list[Use] = []
    velocities: list[Use] = []
    for uses in running.by_topic().values():
        first = uses[0]
        if any(use.role != first.role for use in uses) or "Twist" not in str(first.type):
            continue
        if first.role == "subscription" and len(uses) == 1 and first.given is not None and _is_mux(first):
            inputs.append(first)
        if first.role == "publisher" and len(uses) == 1 and first.remapping is not None:
            velocities.append(first)
    return inputs, velocities


def _is_mux(use: Use) -> bool:
    return use.of_table and literal_text(use.node.started.package) == _MUX


def _is_alike(velocity: Use, use: Use) -> bool:
    words, others = _words(velocity.topic), _words(use.topic)
    return bool(words) and words == others and velocity.type == use.type


def _words(topic: str) -> frozenset[str]:
    return frozenset(re.split(r"[/_]", topic)) - _COMMON - {""}


def _is_mentioned(topics: Topics, use: Use) -> bool:
    """Whether anything names a topic in another place than the one that gives it."""
    place = use.name_place
    name = re.compile(rf"(?<![\w/])/?{re.escape(use.topic.lstrip('/'))}(?![\w/])")
    named = (source for source in topics.files.sources if use.topic.lstrip("/") in source.text)
    found = ((source, match) for source in named for match in name.finditer(source.text))
    return any(
        place is None or source is not place.source or not place.start <= match.start() <= place.end
        for source, match in found
    )
