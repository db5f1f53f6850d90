"""IP addresses, networks and ports, and what an address means: this computer, all interfaces, or another computer.

Formats that wrap an address in a grammar of their own (a socket of systemd, a port of compose) are read by their
parsers, which ask here about the address inside. Units import this module for ports alone, so that ``ipaddress`` is
imported by the first address.
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    import ipaddress

    Address = ipaddress.IPv4Address | ipaddress.IPv6Address
    Interface = ipaddress.IPv4Interface | ipaddress.IPv6Interface
    """An address with the length of its network's prefix."""
    Network = ipaddress.IPv4Network | ipaddress.IPv6Network

HIGHEST_PORT = 65535
PREFIX_LENGTH = {4: 32, 6: 128}
"""The longest prefix of each family."""

_WITH_PORT = regex(r"(?P<host>\[[^\]]*\]|[^:\[\]]+)(?::(?P<port>[^:]*))?$")
_SERVER = regex(r"\[?(?P<host>(?=[0-9a-fA-F]*:)[0-9a-fA-F:]+|[^:\[\];]+)\]?(?::\d+)?")
_QUAD = regex(r"[0-9]{1,18}(?:\.[0-9]{1,18}){3}")


def parse_address(text: str) -> Address | None:
    from ipaddress import ip_address

    try:
        return ip_address(str(text))
    except ValueError:
        return None


def parse_interface(text: str) -> Interface | None:
    """An address that is written with its prefix length."""
    from ipaddress import ip_interface

    try:
        return ip_interface(str(text)) if "/" in text else None
    except ValueError:
        return None


def parse_network(text: str) -> Network | None:
    """A network, also where bits of the host are set."""
    from ipaddress import ip_network

    try:
        return ip_network(str(text), strict=False)
    except ValueError:
        return None


def is_address(text: str, family: int = 0) -> bool:
    """IPv4 or IPv6, the latter also with a zone; ``family`` 4 or 6 takes only one of them."""
    address = parse_address(text)
    return address is not None and family in (0, address.version)


def is_plain_address(text: str, family: int) -> bool:
    """What ``inet_pton`` takes: an address without a zone."""
    return "%" not in text and is_address(text, family)


def is_prefix_length(text: str, family: int) -> bool:
    return text.isascii() and text.isdecimal() and int(text[:9]) <= PREFIX_LENGTH[family]


def quad(text: str) -> tuple[int, ...] | None:
    """Four numbers with dots between them, which may be too large for an address."""
    return tuple(map(int, text.split("."))) if _QUAD.fullmatch(text) else None


def is_port(text: str) -> bool:
    """A decimal number from 1 to 65535."""
    return text.isascii() and text.isdecimal() and 0 < int(text[:9]) <= HIGHEST_PORT


def split_port(text: str) -> tuple[str, str | None]:
    """``HOST``, ``HOST:PORT`` or ``[ADDRESS]:PORT``: the host as it is written, and the port."""
    match = _WITH_PORT.match(text)
    return (match["host"], match["port"]) if match else (text, None)


def host_of(text: str) -> str:
    """The host of ``HOST:PORT``, without brackets."""
    return split_port(text)[0].strip("[]")


def address_of(peer: str) -> Address | None:
    """The address of a peer, without its port; None for a host name."""
    return parse_address(host_of(peer))


def is_loopback(host: str) -> bool:
    """Whether a host is this computer, by name or by address."""
    address = parse_address(host.strip("[]"))
    return host.lower() == "localhost" if address is None else address.is_loopback


def is_wildcard(host: str) -> bool:
    """Whether a server that listens on it listens on all interfaces."""
    address = parse_address(host.strip("[]"))
    return host in ("", "*") if address is None else address.is_unspecified


def is_elsewhere(host: str) -> bool:
    """Whether a text is the address of one other computer."""
    address = parse_address(host)
    return address is not None and not (address.is_loopback or address.is_multicast or address.is_unspecified)


def hosts_in(value: Located) -> Iterator[Located]:
    """The hosts of ROS_STATIC_PEERS or ROS_DISCOVERY_SERVER, separated by semicolons, without their ports."""
    at = 0
    for part in value.split(";"):
        found = _SERVER.fullmatch(part.strip())
        if found is not None:
            start = at + part.index(part.strip()) + found.start("host")
            yield value.part(start, start + len(found["host"]))
        at += len(part) + 1
