"""Topic names that are probably misspelt, and the names that were meant."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.topics.questions.unmatched import BY_HAND
from bringup_lint.graph.topics.questions.unmatched import unmatched_endpoints
from bringup_lint.graph.topics.resolved.endpoint_use import Running
from bringup_lint.graph.topics.resolved.endpoint_use import Use
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span
from bringup_lint.spelling import nearest
from bringup_lint.spelling import numbered

if TYPE_CHECKING:
    from bringup_lint.graph.topics.topics import Topics

COMPARED = 500
"""Unmatched topics of one robot for which another name is sought."""
SHORTEST = 4
"""Letters of a word that may be misspelt."""


class Misspelt(NamedTuple):
    use: Use
    """The side that has no other side."""
    meant: Use
    """The other side, under the other name."""
    near: str
    """The other name."""
    correction: tuple[Located, str] | None
    """What to write where more places use the other name, and it can be written; else either may be the typo."""


class ProbableTypo(NamedTuple):
    use: Use
    """The side that has no other side."""
    meant: Use
    """The other side, under the other name."""
    near: str
    evidence: str = "topics"
    """``topics``: all those of the running nodes are known; ``name``: only that the names are nearly equal; ``type``:
    only that nothing else uses the type."""


def misspelt(topics: Topics) -> Iterator[Misspelt]:
    """The topics whose names are probably misspelt, each pair of places once: first where all topics of what runs
    together are known."""
    said: set[frozenset[Span]] = set()
    for running in sorted(topics.runs, key=lambda running: not running.complete):
        count = Counter(use.topic for use in running.uses)
        for use, meant, near, evidence in probable_typos(running):
            sides = frozenset(each.name_place or each.where for each in (use, meant))
            if sides in said or not _is_enough(topics, use, evidence):
                continue
            said.add(sides)
            yield Misspelt(use, meant, near, _corrected(use, near) if count[near] > count[use.topic] else None)


def _is_enough(topics: Topics, use: Use, evidence: str) -> bool:
    """Whether nothing that is not known may serve a topic: no other file mentions the last word of its name, and a type
    that nothing else uses is one of the tree's own."""
    if evidence == "topics":
        return True
    last = use.topic.rpartition("/")[2]
    name = re.compile(rf"\b{re.escape(last)}\b")
    others = (source.text for source in topics.files.sources if source is not use.where.source)
    if any(last in text and name.search(text) for text in others):
        return False
    return evidence != "type" or (use.type or "").partition("/")[0] in topics.launch.workspace.packages


def probable_typos(running: Running) -> Iterator[ProbableTypo]:
    """Subscriptions that nobody serves beside a publisher of the same type under nearly the same name, and publishers
    that nobody hears beside such a subscription. Where not all topics are known, only the first, in sources of the
    tree under names that nothing else gives."""
    if not running.complete:
        yield from _typos_of_sources(running)
        return
    alone = list(unmatched_endpoints(running))
    topics = {use.topic for use in alone}
    seen = set()
    for use in alone[:COMPARED]:
        others = [each for each in running.uses if each.role != use.role and each.type == use.type and use.type]
        others = [each for each in others if each.node is not use.node]
        if use.role == "publisher":
            others = [each for each in others if each.topic in topics]
        found = _meant(use, others, topics)
        if found is None or frozenset((use.topic, found.topic)) in seen:
            continue
        seen.add(frozenset((use.topic, found.topic)))
        if _is_fixed(use) and found.topic in topics:
            use, found = found, use
        yield ProbableTypo(use, found, found.topic)


def _typos_of_sources(running: Running) -> Iterator[ProbableTypo]:
    """Subscriptions beside the one publisher in a source of the tree that has their type and nearly their name, or that
    alone has their type and is heard by nobody."""
    alone = [each for each in unmatched_endpoints(running) if _is_of_source(each)]
    topics = {each.topic for each in alone}
    senders = [each for each in running.uses if each.role == "publisher" and each.type and _is_of_source(each)]
    for use in alone[:COMPARED]:
        if use.role != "subscription" or use.conditional:
            continue
        others = [each for each in senders if each.type == use.type]
        found = _meant(use, [each for each in others if nearly_equal(each.topic, use.topic)], topics)
        if found is not None:
            yield ProbableTypo(use, found, found.topic, "name")
            continue
        found = _only(use, others, [each for each in running.uses if each.type == use.type], topics)
        if found is not None:
            yield ProbableTypo(use, found, found.topic, "type")


def _is_of_source(use: Use) -> bool:
    """Whether a source of the tree alone gives a name."""
    is_plain = use.remapping is None and use.given is None and isinstance(use.written, Located)
    return is_plain and not use.of_table and not use.implied and not use.shown


def _only(use: Use, senders: list[Use], same: list[Use], alone: set[str]) -> Use | None:
    """The one publisher of a type, of another node and heard by nobody, when nothing else uses the type."""
    if len(senders) != 1 or len({each.topic for each in same}) != 2 or BY_HAND.search(use.topic):
        return None
    return senders[0] if senders[0].topic in alone and senders[0].node is not use.node else None


def _is_fixed(use: Use) -> bool:
    return use.of_table and use.remapping is None and use.given is None


def _meant(use: Use, others: Iterable[Use], alone: set[str]) -> Use | None:
    """The one name that is nearly the same: one part an edit or two away, or the same name in another namespace that is
    alone as well."""
    by_name = {each.topic: each for each in others if not numbered(each.topic, use.topic)}
    near = [name for name in by_name if nearly_equal(name, use.topic)]
    if not near:
        near = [name for name in by_name if name in alone and _nested(name, use.topic)]
    return by_name[near[0]] if len(near) == 1 else None


def nearly_equal(one: str, other: str) -> bool:
    """Whether two names differ in one part only, and there by a slip in one word, or in underscores. Numbers are other
    names, and a few letters are another word: ``/arm_l/state`` and ``/arm_r/state``."""
    ours, theirs = one.split("/"), other.split("/")
    if len(ours) != len(theirs) or numbered(one, other):
        return False
    apart = [(own, their) for own, their in zip(ours, theirs, strict=True) if own != their]
    return len(apart) == 1 and min(map(len, apart[0])) >= SHORTEST and _slipped(*apart[0])


def _slipped(one: str, other: str) -> bool:
    ours, theirs = one.split("_"), other.split("_")
    if len(ours) != len(theirs):
        return "".join(ours) == "".join(theirs)
    apart = [(own, their) for own, their in zip(ours, theirs, strict=True) if own != their]
    return len(apart) == 1 and bool(nearest(apart[0][0], [apart[0][1]]))


def _nested(one: str, other: str) -> bool:
    """Whether a name is the other one in a namespace: ``/scan`` and ``/front/scan``."""
    return one.endswith(other) or other.endswith(one)


def _corrected(use: Use, name: str) -> tuple[Located, str] | None:
    """What to write instead of a name in the source, so that it becomes another full name; None when a remapping or
    parameter gives the name, or when it cannot be written there."""
    written = use.written
    if use.remapping is not None or use.given is not None or not isinstance(written, Located) or use.of_table:
        return None
    if written.span.text != written:  # an f-string or a sum
        return None
    if written.startswith("/"):
        return written, name
    before = use.topic[: len(use.topic) - len(written)] if use.topic.endswith(written) else None
    if before is None or not name.startswith(before) or len(name) == len(before):
        return None
    return written, name[len(before) :]
