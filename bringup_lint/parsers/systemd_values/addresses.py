"""Network addresses: what sockets listen on, prefixes for IPAddressAllow=, ports for SocketBindAllow=."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.addresses import HIGHEST_PORT
from bringup_lint.addresses import is_address
from bringup_lint.addresses import is_plain_address
from bringup_lint.addresses import is_prefix_length
from bringup_lint.parsers.systemd_values.enumerations import enumerations
from bringup_lint.parsers.systemd_values.numbers import parse_integer
from bringup_lint.parsers.systemd_values.problems import LINE
from bringup_lint.parsers.systemd_values.problems import WORD
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.parsers.systemd_values.specifiers import check_specifiers
from bringup_lint.parsers.systemd_values.specifiers import literal
from bringup_lint.parsers.systemd_values.word_splitting import split_words
from bringup_lint.pattern import regex
from bringup_lint.source import Located

LISTEN = "a port, address:port, an absolute path or @name"
_NAMED_PREFIXES = ("any", "localhost", "link-local", "multicast")
_LOCALHOST = regex(r"(?:.+\.)?localhost(?:\.localdomain)?\.?", re.IGNORECASE)


def is_port(text: str) -> bool:
    number = parse_integer(text) if text[:1].isdecimal() else None
    return number is not None and 0 < number <= HIGHEST_PORT


def is_listen_address(text: str) -> bool:
    if text.startswith("/") or text.startswith("@"):
        return 1 < len(text.encode("utf-8", "surrogateescape")) < 108
    if text.startswith("vsock:"):
        cid, colon, port = text[6:].partition(":")
        return bool(colon) and parse_integer(port) is not None and (not cid or parse_integer(cid) is not None)
    if is_port(text):
        return True
    address, _, scope = text.partition("%")
    if not scope and "%" in text:
        return False
    host, colon, port = address.rpartition(":")
    if not colon or not is_port(port):
        return False
    if host.startswith("[") and host.endswith("]"):
        return is_address(host[1:-1], 6)
    return is_address(host, 4)


def check_listen(value: Located, version: int, *, local: bool = False) -> Iterator[ValueProblem]:
    bad = list(check_specifiers(value, version))
    yield from bad
    text = literal(value)
    if bad or text is None:
        return
    if not is_listen_address(text):
        yield ValueProblem("invalid", value, LISTEN)
    elif local and text[0] not in "/@":
        yield ValueProblem("invalid", value, "an absolute path or @name")


def check_listen_local(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_listen(value, version, local=True)


def check_listen_netlink(value: Located, version: int) -> Iterator[ValueProblem]:
    bad = list(check_specifiers(value, version))
    yield from bad
    words = value.split(None, 1)
    if bad or "%" in value:
        return
    if (words[0] not in enumerations()["netlink-family"] and parse_integer(words[0]) is None) or (
        len(words) > 1 and parse_integer(words[1]) is None
    ):
        yield ValueProblem("invalid", value, "a netlink family such as kobject-uevent and a group")


def check_address_prefixes(value: Located, version: int) -> Iterator[ValueProblem]:
    for word in split_words(value, quotes=False).words:
        if word in _NAMED_PREFIXES or _LOCALHOST.fullmatch(word):
            continue
        address, slash, length = word.partition("/")
        family = next((each for each in (4, 6) if is_plain_address(address, each)), None)
        if family is None or (slash and not is_prefix_length(length, family)):
            yield ValueProblem(
                "invalid",
                word,
                "an address, an address/length, any, localhost, link-local or multicast",
                WORD,
            )


def check_socket_bind(value: Located, version: int) -> Iterator[ValueProblem]:
    """``[FAMILY:][PROTOCOL:]PORTS`` or ``any``."""
    tokens = value.split(":")
    rest = list(tokens)
    if rest and rest[0] in ("ipv4", "ipv6"):
        rest.pop(0)
    if rest and rest[0] in ("tcp", "udp"):
        rest.pop(0)
    if rest and (rest[0] == "any" or _is_port_range(rest[0])):
        rest.pop(0)
    if rest or not value:
        yield ValueProblem("invalid", value, "any, or a port or range after ipv4:, ipv6:, tcp: or udp:", LINE)


def _is_port_range(text: str) -> bool:
    low, dash, high = text.partition("-")
    return is_port(low) and (not dash or (is_port(high) and (parse_integer(low) or 0) <= (parse_integer(high) or 0)))
