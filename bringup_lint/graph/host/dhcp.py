"""Ranges of addresses that dnsmasq gives out, and the addresses of the interface on which it does."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from collections.abc import Iterator
from ipaddress import IPv4Address
from typing import TYPE_CHECKING

from bringup_lint import addresses
from bringup_lint.graph.host.options import option_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.netplan.netplan import Netplan
    from bringup_lint.source import Located
    from bringup_lint.source import Source

_QUAD = r"\d{1,3}(?:\.\d{1,3}){3}"
_RANGE = regex(
    rf"^[ \t]*dhcp-range=(?:(?:(?:set|tag|interface):)?(?P<name>[A-Za-z][\w.-]*),)*"
    rf"(?P<first>{_QUAD}),(?P<last>{_QUAD})(?P<rest>[^\n#]*)",
    re.M,
)
_DHCPCD = regex(
    rf"^interface[ \t]+(?P<name>[\w.-]+)(?![\w.-])[^\n]*\n(?:(?!interface\b|profile\b|ssid\b)[^\n]*\n){{0,20}}?"
    rf"[ \t]*static[ \t]+ip_address=(?P<address>{_QUAD}(?:/\d+)?)",
    re.M,
)


class LostRange(NamedTuple):
    """A range from which nobody gets an address."""

    first: Located
    interface: str
    address: Located | None
    """That of the interface; None where the range itself is upside down."""


def lost_ranges(files: Files, netplan: Callable[[], Netplan], source: Source) -> Iterator[LostRange]:
    """Each range that is upside down; the first of the others where none is of the interface's network."""
    starts: dict[Located, IPv4Address] = {}
    for match in _RANGE.finditer(source.text):
        first = source.located(*match.span("first"))
        start, end = (addresses.parse_address(match[name]) for name in ("first", "last"))
        if isinstance(start, IPv4Address) and isinstance(end, IPv4Address):
            if start > end:
                yield LostRange(first, "", None)
            else:
                starts[first] = start
    if starts and len(re.findall(r"^[ \t]*interface=", source.text, re.M)) == 1:
        yield from _outside(files, netplan, source, starts)


def _outside(
    files: Files, netplan: Callable[[], Netplan], source: Source, starts: dict[Located, IPv4Address]
) -> Iterator[LostRange]:
    interface = option_of(source, "interface")
    found = list(_addresses(files, netplan, str(interface)))
    known = [each for each in found if files.same_robot(source, each[0].span.source)]
    networks = {each.network for _, each in known}
    fits = any(start in network for start in starts.values() for network in networks)
    first, start = next(iter(starts.items()))
    if known and not fits and not _is_used(files, source, start):
        yield LostRange(first, str(interface), known[0][0])


def _addresses(
    files: Files, netplan: Callable[[], Netplan], name: str
) -> Iterator[tuple[Located, addresses.Interface]]:
    """The fixed addresses of an interface, in netplan and in dhcpcd.conf."""
    found: list[Located] = []
    if files.of_kind("netplan"):
        named = (each for each in netplan().interfaces if each.device == name)
        found += [address.text for each in named for address in each.addresses]
    for path in files.tree.named("dhcpcd.conf"):
        source = files.tree.at(path)
        if source is not None and source.judged:
            matches = (match for match in _DHCPCD.finditer(source.text) if match["name"] == name)
            found += [source.located(*match.span("address")) for match in matches]
    for text in found:
        parsed = addresses.parse_interface(text)
        if parsed is not None:
            yield text, parsed


def _is_used(files: Files, source: Source, start: IPv4Address) -> bool:
    """Whether another file knows an address of the range's network, so that something may set it."""
    prefix = str(start).rpartition(".")[0]
    near = re.compile(rf"(?<![\d.]){re.escape(prefix)}\.\d")
    folder = os.path.dirname(source.name)
    others = (each for each in files.sources if each is not source and os.path.dirname(each.name) != folder)
    return any(near.search(each.text) and files.same_robot(source, each) for each in others)
