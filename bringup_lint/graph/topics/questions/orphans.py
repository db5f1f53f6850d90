"""A topic that nobody publishes, and one of its type beside it that nobody takes: one name was changed, and one not."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.topics.questions.apart import End
from bringup_lint.graph.topics.questions.apart import are_together
from bringup_lint.graph.topics.questions.apart import ends_of
from bringup_lint.graph.topics.questions.apart import may_be_left
from bringup_lint.graph.topics.questions.unmatched import EVERYWHERE
from bringup_lint.graph.topics.questions.unmatched import FIRMWARE
from bringup_lint.graph.topics.questions.unmatched import FIRMWARE_TYPES
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.source import Source

_UNJUDGED = (Purpose.TEST, Purpose.CI, Purpose.ARCHIVE, Purpose.EXAMPLE)
_ANOTHER = frozenset(
    "is state status done request response command cmd desired target current measured feedback filtered".split()
)
"""Words that make another topic of one: a command, and what came of it."""
_NAMESPACED = 2
"""Slashes of a name in a namespace: what stands at the root may be of anybody."""
_MOST = 300
"""Topics with one side for which the other one is sought."""


class Orphans(NamedTuple):
    subscription: End
    publisher: End


def orphans(topics: Topics, said: set[str]) -> Iterator[Orphans]:
    """Pairs in one namespace, of which each is the only one for the other, in nodes of several files. Their type is one
    of the tree's own, or one name has all words of the other; no other file of the robot mentions either name.

    ``said``: topics to leave out.
    """
    alone = _alone(topics)
    subscriptions = [each for each in alone if each.role == "subscription"][:_MOST]
    publishers = [each for each in alone if each.role == "publisher"][:_MOST]
    for subscription in subscriptions:
        if FIRMWARE.search(subscription.topic) or str(subscription.type).startswith(FIRMWARE_TYPES):
            continue
        if subscription.topic.count("/") < _NAMESPACED or subscription.topic in said:
            continue
        near = [each for each in publishers if _belong(topics, each, subscription)]
        if len(near) == 1 and sum(_belong(topics, near[0], each) for each in subscriptions) == 1:
            ends = (subscription, near[0])
            if not may_be_left(subscription.where) and not any(_is_mentioned(topics, each, ends) for each in ends):
                yield Orphans(*ends)


def _alone(topics: Topics) -> list[End]:
    """The first end of each topic that has one side, in all that the tree starts or may start."""
    found: dict[str, list[End]] = {}
    for end in ends_of(topics, everything=True):
        found.setdefault(end.topic, []).append(end)
    one_sided = (ends for topic, ends in found.items() if topic not in EVERYWHERE and len({e.role for e in ends}) == 1)
    return [ends[0] for ends in one_sided if all(each.is_for_robot for each in ends)]


def _belong(topics: Topics, publisher: End, subscription: End) -> bool:
    ours, theirs = publisher.topic.rpartition("/"), subscription.topic.rpartition("/")
    if publisher.type is None or publisher.type != subscription.type or ours[0] != theirs[0]:
        return False
    if publisher.name.source is subscription.name.source or publisher.where.source is subscription.where.source:
        return False
    is_own = publisher.type.partition("/")[0] in topics.launch.workspace.packages
    words, others = {*ours[2].split("_")}, {*theirs[2].split("_")}
    is_more = (words <= others or others <= words) and not (words ^ others) & _ANOTHER
    return (is_own or is_more) and are_together(topics, publisher.name.source, subscription.name.source)


def _is_mentioned(topics: Topics, end: End, ends: tuple[End, End]) -> bool:
    """Whether another file than those of both ends mentions a name, or its last part with a slash before it, or a
    program remaps its own."""
    if f"{end.topic}:=" in end.where.source.said:
        return True
    own: set[Source] = {place.source for each in ends for place in (each.name, each.where)}
    name = re.compile(rf"(?<![\w/])/?{re.escape(end.topic.lstrip('/'))}(?![\w/])")
    others = (each for each in topics.files.sources if each not in own and end.topic.lstrip("/") in each.text)
    return any(name.search(each.text) for each in others if topics.files.purpose(each) not in _UNJUDGED)
