"""Subscriptions to which no publisher of the tree can send, in nodes that are started apart from each other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.facts.ros.node_topics import published
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.memo import kept
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.topics.questions.compatibility import Conflict
from bringup_lint.graph.topics.questions.compatibility import conflicts
from bringup_lint.graph.topics.resolved.names import tail
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.node_source import Endpoint
    from bringup_lint.model.node_source import Qos

_OF_FIRMWARE = (".ino", ".c", *CPP)
_SIZE = 100_000
_LEAVES = regex(r"\bif\s{0,4}\([^;{}]{0,300}\)\s{0,40}(?:\{[^{}]{0,600})?\breturn\b", hints="return")


class End(NamedTuple):
    """One side of a topic, as a source of the tree makes it."""

    role: str
    topic: str
    """As a launch file makes it of the name; the name itself where none starts the node."""
    type: str | None
    qos: Qos | None
    where: Span
    label: str
    """What to call its node in a message."""
    name: Span
    """Where its name is written, by a parameter, a remapping or the source."""
    is_for_robot: bool


class UnservedApart(NamedTuple):
    """A subscription that asks for more than each publisher of its topic offers."""

    subscription: End
    publishers: list[End]
    conflict: Conflict
    """With the first of the publishers."""
    others: list[End]
    """More subscriptions of the file, to other topics with the same profile."""


def unserved_apart(topics: Topics) -> Iterator[UnservedApart]:
    """Subscriptions of a source that ask all publishers of the tree for too much, those with one cause together. Left
    out are topics that a driver of others may publish as well, and those that anything remaps."""
    found: dict[tuple[Source, tuple[Span, ...]], UnservedApart] = {}
    for each in _all(topics):
        name = each.subscription.topic.rpartition("/")[2]
        if any(name in text for text in _firmware(topics)):
            continue  # it may publish the topic with another profile
        profiles = tuple(end.qos.span for end in each.publishers if end.qos is not None)
        key = (each.subscription.where.source, profiles[:1])
        if key in found:
            found[key].others.append(each.subscription)
        else:
            found[key] = each
    yield from found.values()


@kept
def _firmware(topics: Topics) -> list[str]:
    """The sources of firmware with micro-ROS."""
    tree = topics.files.tree
    heads = (tree.head(path, _SIZE) for path in tree.paths if path.endswith(_OF_FIRMWARE))
    return [text for text in heads if "rclc_" in text or "rclc/" in text]


def _all(topics: Topics) -> Iterator[UnservedApart]:
    met = {(pair.publisher.where, pair.subscription.where) for pair in topics.pairs}
    for ends in _by_topic(topics).values():
        publishers = [each for each in ends if each.role == "publisher"]
        for subscription in ends:
            if subscription.role == "publisher" or any((each.where, subscription.where) in met for each in publishers):
                continue
            found = [_conflict(topics, each, subscription) for each in publishers]
            conflict = found[0] if found and None not in found else None
            if conflict is not None:
                yield UnservedApart(subscription, publishers, conflict, [])


def _conflict(topics: Topics, publisher: End, subscription: End) -> Conflict | None:
    if publisher.qos is None or subscription.qos is None or publisher.type != subscription.type:
        return None
    if not are_together(topics, publisher.where.source, subscription.where.source):
        return None
    return next(conflicts(publisher.qos, subscription.qos), None)


def are_together(topics: Topics, one: Source, other: Source) -> bool:
    """Whether two files are for the same robot: packages of one workspace are, of which there is one each."""
    workspace = topics.launch.workspace
    owners = [workspace.owner(each) for each in (one, other)]
    if all(each is not None and each.name not in workspace.ambiguous for each in owners):
        return True
    return topics.files.same_robot(one, other)


def _by_topic(topics: Topics) -> dict[str, list[End]]:
    """The ends by full name. Of nodes that no launch file starts, relative names count as without a namespace."""
    found: dict[str, list[End]] = {}
    public = published()
    rules = (pair for node in topics.launch.nodes for pair in node.remappings)
    remapped = {tail(text) for pair in rules for side in pair if (text := text_of(side))}
    for end in ends_of(topics):
        if end.topic.lstrip("/") not in public and tail(end.topic) not in remapped:
            found.setdefault(end.topic, []).append(end)
    return found


def ends_of(topics: Topics, *, everything: bool = False) -> Iterator[End]:
    """The ends in the sources of the robot; ``everything``: also those of public nodes, and for other purposes."""
    seen: set[tuple[Span, str]] = set()
    for running in topics.runs:
        for use in running.uses:
            key = (use.where, use.topic)
            if key in seen or use.shown or use.implied or (use.of_table and not everything):
                continue
            seen.add(key)
            place = use.name_place or use.where
            is_for_robot = not running.simulated and _is_for_robot(topics, place.source)
            if is_for_robot or everything:
                yield End(use.role, use.topic, use.type, use.qos, use.where, use.node.label(), place, is_for_robot)
    launched = {where for where, _ in seen}
    for source, label, each in named_in_sources(topics):
        name = each.name
        if each.span in launched or name is None or each.parameter is not None or str(name).startswith("~"):
            continue
        is_for_robot = _is_for_robot(topics, source)
        if each.role in ("publisher", "subscription") and (is_for_robot or everything):
            topic = f"/{name.lstrip('/')}"
            yield End(each.role, topic, each.type, each.qos, each.span, label, name.span, is_for_robot)


def named_in_sources(topics: Topics) -> Iterator[tuple[Source, str, Endpoint]]:
    """The ends in all sources, with what to call their nodes."""
    for node in topics.nodes.classes:
        for endpoint in node.endpoints:
            yield node.source, str(node.node_name or node.name or node.source.basename), endpoint
    for found in topics.nodes.cpp:
        for endpoint in found.endpoints:
            yield found.source, found.source.basename, endpoint


def may_be_left(where: Span) -> bool:
    """Whether a C++ file leaves a function before a place, perhaps that one."""
    source = where.source
    return source.kind == "cpp-node" and _LEAVES.search(source.said, 0, where.start) is not None


def _is_for_robot(topics: Topics, source: Source) -> bool:
    return topics.nodes.purpose(source) in (Purpose.ROBOT, Purpose.DEVELOPMENT)
