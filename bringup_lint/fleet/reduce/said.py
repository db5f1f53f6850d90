"""One thing that decides how a robot's DDS behaves on the network."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

TRANSPORT = "transport"
PORT = "discovery port"
PROTOCOL = "discovery protocol"
TAG = "domain tag"
REACH = "way of discovery"


class Said(NamedTuple):
    key: str
    value: str
    where: Located | None = None
    """None for a default."""


def port(base: int, gain: int) -> str:
    """The port at which a domain is discovered (RTPS 2.5, 9.6.2.3)."""
    return f"{base} + {gain} × domain"
