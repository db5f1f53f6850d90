"""Inputs of twist_mux that nobody feeds, beside a velocity of the same name that nobody takes."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.topics.questions.command_sources import is_mux
from bringup_lint.graph.topics.resolved.endpoint_use import Pair
from bringup_lint.graph.topics.resolved.endpoint_use import Running
from bringup_lint.graph.topics.resolved.endpoint_use import Use

if TYPE_CHECKING:
    from bringup_lint.graph.topics.topics import Topics

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
        for inputs, velocities in _alike(running):
            if len(inputs) != 1 or len(velocities) != 1 or inputs[0].given in seen or inputs[0].topic in said:
                continue
            seen.add(inputs[0].given)
            if not any(_is_mentioned(topics, each) for each in (inputs[0], velocities[0])):
                yield Pair(velocities[0], inputs[0])


def _alike(running: Running) -> Iterable[tuple[list[Use], list[Use]]]:
    """The inputs that nobody feeds, and the remapped velocities that nobody takes, those with the same words and type
    together."""
    found: dict[tuple[frozenset[str], object], tuple[list[Use], list[Use]]] = {}
    for uses in running.by_topic().values():
        use, *others = uses
        words = _words(use.topic) if not others and "Twist" in str(use.type) else None
        if not words:
            continue
        inputs, velocities = found.setdefault((words, use.type), ([], []))
        if use.role == "subscription" and use.given is not None and use.of_table and is_mux(use.node):
            inputs.append(use)
        elif use.role == "publisher" and use.remapping is not None:
            velocities.append(use)
    return found.values()


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
