"""What timers delay, and what the delayed part waits for."""

from __future__ import annotations

import re

from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import exclusive
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import Timer
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import walk
from bringup_lint.pattern import regex
from bringup_lint.source import Span

_WAITING = regex(
    r"\b(?:wait\w*|until|ready|available|before|depends?|first|last|comes? up|started|running|initiali[sz]\w+)\b", re.I
)
_DELAY = regex(r"\b(?:delay|timer|sleep)", re.I)
NEAR = 3
"""Lines above a timer in which a comment speaks of it."""


def delayed(expansion: Expansion, timer: Timer) -> list[Started]:
    """What a timer starts on a robot, without what waits by itself: spawners for their controller manager, components
    for their container."""
    inside = (node for node in expansion.nodes if timer in node.context)
    return [node for node in inside if not _waits_itself(node) and not only_simulated(node)]


def undelayed(expansion: Expansion, others: list[Started]) -> list[Started]:
    """What starts at once, together with others."""
    started = (node for node in expansion.nodes if not node.context)
    return [node for node in started if not any(exclusive(node, other) for other in others)]


def _waits_itself(node: Started) -> bool:
    return isinstance(node.action, ComposableNode) or "spawner" in str(literal_text(node.executable))


def only_simulated(node: Started) -> bool:
    """Whether a condition lets a node start only in a simulation."""
    return any(
        isinstance(each, Argument) and "sim" in each.name and condition.wanted
        for condition in node.conditions
        for each in walk(condition.predicate)
    )


def waiting_comment(file: LaunchFile, timer: Timer) -> Span | None:
    """A comment inside the timer, or one just above that speaks of the delay, which says that something waits."""
    source = file.source
    mark = "<!--" if file.format == "xml" else "#"
    first = timer.span.line
    last = source.position(timer.span.end).line
    for number in range(max(first - NEAR, 1), last + 1):
        text = source.line_text(number)
        comment = text.partition(mark)[2]
        if _WAITING.search(comment) and (number >= first or _DELAY.search(comment)):
            start = source.line_starts[number - 1] + text.index(mark)
            return source.span(start, start + len(mark + comment.rstrip()))
    return None
