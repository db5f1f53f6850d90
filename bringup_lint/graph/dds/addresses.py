"""Addresses of hosts as peers and discovery servers name them."""

from __future__ import annotations

import ipaddress
import re
from collections.abc import Iterator

from bringup_lint.source import Located

Address = ipaddress.IPv4Address | ipaddress.IPv6Address

WITH_PORT = re.compile(r"(?P<host>\[[^\]]*\]|[^:\[\]]+)(?::(?P<port>[^:]*))?$")
_SERVER = re.compile(r"\[?(?P<host>[0-9a-fA-F:]*:[0-9a-fA-F:]*|[^:\[\];]+)\]?(?::\d+)?")


def host_of(text: str) -> str:
    """A peer's host without its port."""
    match = WITH_PORT.match(text)
    return match["host"].strip("[]") if match else text


def is_address(text: str) -> bool:
    try:
        ipaddress.ip_address(text)
    except ValueError:
        return False
    return True


def address_of(peer: str) -> Address | None:
    """The address of a peer, without its port; None for a host name."""
    try:
        return ipaddress.ip_address(host_of(peer))
    except ValueError:
        return None


def is_elsewhere(host: str) -> bool:
    """Whether a text is the address of one other machine."""
    try:
        address = ipaddress.ip_address(host)
    except ValueError:
        return False
    return not (address.is_loopback or address.is_multicast or address.is_unspecified)


def hosts_in(value: Located) -> Iterator[Located]:
    """The hosts of ROS_STATIC_PEERS or ROS_DISCOVERY_SERVER, separated by semicolons, without their ports."""
    at = 0
    for part in value.split(";"):
        found = _SERVER.fullmatch(part.strip())
        if found is not None:
            start = at + part.index(part.strip()) + found.start("host")
            yield value.part(start, start + len(found["host"]))
        at += len(part) + 1
