"""Which publisher and subscription of one topic never match, as rmw and DDS decide it (``qos_check_compatible``)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.endpoint_use import Use
    from bringup_lint.model.node_source import Qos


class Conflict(NamedTuple):
    """A policy of which the publisher offers less than the subscription asks for."""

    policy: str
    """``reliability``, ``durability``, ``deadline``, ``liveliness`` or ``lease duration``."""
    offered: str
    asked: str


def types_differ(publisher: Use, subscription: Use) -> bool:
    return None not in (publisher.type, subscription.type) and publisher.type != subscription.type


def conflicts_of(publisher: Use, subscription: Use) -> Iterator[Conflict]:
    """Where the publisher offers less than the subscription asks for, as far as both are known."""
    if publisher.qos is not None and subscription.qos is not None:
        yield from conflicts(publisher.qos, subscription.qos)


def conflicts(publisher: Qos, subscription: Qos) -> Iterator[Conflict]:
    """What keeps the two apart. Policies that are not known, or left to the middleware, are never in conflict; history,
    depth and lifespan do not matter."""
    if publisher.reliability == "BEST_EFFORT" and subscription.reliability == "RELIABLE":
        yield Conflict("reliability", "best effort", "reliable")
    if publisher.durability == "VOLATILE" and subscription.durability == "TRANSIENT_LOCAL":
        yield Conflict("durability", "volatile", "transient local")
    if _longer(publisher.deadline, subscription.deadline):
        yield Conflict("deadline", _seconds(publisher.deadline), _seconds(subscription.deadline))
    if publisher.liveliness == "AUTOMATIC" and subscription.liveliness == "MANUAL_BY_TOPIC":
        yield Conflict("liveliness", "automatic", "manual by topic")
    if _longer(publisher.lease, subscription.lease):
        yield Conflict("lease duration", _seconds(publisher.lease), _seconds(subscription.lease))


def _longer(offered: float | None, asked: float | None) -> bool:
    """``float('inf')`` and zero both mean that there is none."""
    if offered is None or asked is None or asked in (0, float("inf")):
        return False
    return offered == 0 or offered > asked


def _seconds(duration: float | None) -> str:
    return "none" if duration in (None, 0, float("inf")) else f"{duration:g} s"
