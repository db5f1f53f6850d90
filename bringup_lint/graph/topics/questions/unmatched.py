"""Topics with only one side, and the name that was probably meant."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.topics.resolved.endpoint_use import Running
from bringup_lint.graph.topics.resolved.endpoint_use import Use
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.spelling import nearest
from bringup_lint.spelling import numbered

EVERYWHERE = (
    "/rosout",
    "/parameter_events",
    "/clock",
    "/tf",
    "/tf_static",
    "/diagnostics",
    "/diagnostics_agg",
    "/bond",
)
"""Topics that tools, or every node, use."""
BY_HAND = regex(
    r"goal|initial_?pose|clicked|command|cmd|joy|teleop|stop|start|trigger|request|enable|reset|mode|feedback|set_|debug|input"
)
"""Topics to which a person, a tool or another computer publishes."""
FIRMWARE = regex(r"^/(?:utlidar|lf|rt|fmu/out)/|^/(?:low|sportmode|wirelesscontroller|handstate)\w*$")
"""Topics that controllers of robots publish by themselves: Unitree's motion computer, PX4."""
FIRMWARE_TYPES = ("unitree_go/", "unitree_hg/", "unitree_api/", "px4_msgs/")
COMPARED = 500
"""Unmatched topics of one robot for which another name is sought."""
SHORTEST = 4
"""Letters of a word that may be misspelt."""


class ProbableTypo(NamedTuple):
    use: Use
    """The side that has no other side."""
    meant: Use
    """The other side, under the other name."""
    near: str
    evidence: str = "topics"
    """``topics``: all those of the running nodes are known; ``name``: only that the names are nearly equal; ``type``:
    only that nothing else uses the type."""


def unmatched_endpoints(running: Running) -> Iterator[Use]:
    """The uses of topics that no other side of the running nodes uses, whether or not it starts by default."""
    for topic, uses in running.by_topic().items():
        if len({use.role for use in uses}) == 1 and topic not in EVERYWHERE:
            yield from (use for use in uses if not use.implied and use.node.started.by_default is True)


def without_publisher(running: Running) -> Iterator[Use]:
    """The subscriptions of sources in the tree that nobody serves, and that nobody serves by hand."""
    for use in unmatched_endpoints(running):
        if use.role != "subscription" or use.of_table or use.conditional or _is_of_firmware(use):
            continue
        if not BY_HAND.search(use.topic):
            yield use


def _is_of_firmware(use: Use) -> bool:
    return bool(FIRMWARE.search(use.topic)) or (use.type or "").startswith(FIRMWARE_TYPES)


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


def corrected(use: Use, name: str) -> tuple[Located, str] | None:
    """What to write instead of a name in the source, so that it becomes another full name; None when a remapping or
    parameter gives the name, or when it cannot be written there."""
    written = use.written
    if use.remapping is not None or use.given is not None or not isinstance(written, Located) or use.of_table:
        return None
    if written.startswith("/"):
        return written, name
    before = use.topic[: len(use.topic) - len(written)] if use.topic.endswith(written) else None
    if before is None or not name.startswith(before) or len(name) == len(before):
        return None
    return written, name[len(before) :]
