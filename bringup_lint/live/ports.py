"""The domains of which this computer has ports open: where nodes may be that no file speaks of."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from pathlib import Path

from bringup_lint.parsers.ros_values import MAX_DOMAIN

TABLES = ("/proc/net/udp", "/proc/net/udp6")
"""The sockets of this network namespace; proc(5)."""
FIRST, STEP = 7400, 250
"""The port of discovery by multicast in domain 0, and how far apart the ports of two domains are; DDSI-RTPS 2.5,
9.6.2.1."""
UNICAST = 10
"""How far above it the ports of the first participant begin: an even one for discovery, and the next one for data."""


def open_domains() -> list[int]:
    """Domains in which a process of this computer takes part, by its ports, ascending."""
    ports = frozenset(port for table in TABLES for port in _ports(table))
    return domains_of(ports)


def domains_of(ports: Iterable[int]) -> list[int]:
    """A single port above that of discovery says nothing: any program may get it from the kernel."""
    known = frozenset(ports)
    found = {_domain(port) for port in known if _is_discovery(port, known)}
    return sorted(domain for domain in found if 0 <= domain <= MAX_DOMAIN)


def _domain(port: int) -> int:
    return (port - FIRST) // STEP


def _is_discovery(port: int, ports: frozenset[int]) -> bool:
    offset = (port - FIRST) % STEP
    if offset == 0:
        return True
    return offset >= UNICAST and offset % 2 == 0 and port + 1 in ports


def _ports(table: str) -> Iterator[int]:
    """None where the kernel shows no such table."""
    try:
        lines = Path(table).read_text().splitlines()[1:]
    except OSError:
        return
    for line in lines:
        _, _, port = line.split()[1].rpartition(":")
        yield int(port, 16)
