"""Which endpoints of one topic never match, as rmw decides it (``qos_check_compatible``)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from bringup_lint.model.living import Qos


class Conflict(NamedTuple):
    """A policy of which the publisher offers less than the subscription asks for."""

    policy: str
    offered: str
    asked: str


def conflicts(publisher: Qos, subscription: Qos) -> Iterator[Conflict]:
    """What keeps the two apart; history, depth and lifespan do not matter."""
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
    return asked is not None and (offered is None or offered > asked)


def _seconds(duration: float | None) -> str:
    return "none" if duration is None else f"{duration:g} s"
