"""The values that netplan accepts: each check tells what is wrong with a scalar, or nothing."""

from __future__ import annotations

import re
from collections.abc import Callable

from bringup_lint.addresses import HIGHEST_PORT
from bringup_lint.addresses import PREFIX_LENGTH
from bringup_lint.addresses import is_plain_address
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Fault
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.pattern import regex

TRUE = frozenset(("true", "on", "yes", "y"))
FALSE = frozenset(("false", "off", "no", "n"))
MAC = regex(r"[0-9a-fA-F]{2}(?::[0-9a-fA-F]{2}){5}(?:(?::[0-9a-fA-F]{2}){14})?\Z")
NAME = regex(r"[!-~]+\Z")
HOST_LABEL = regex(r"[a-z0-9](?:[a-z0-9-]*[a-z0-9])?\Z", re.IGNORECASE)
DIGITS = regex(r"[\t\n\v\f\r ]*[-+]?([0-9]+)")
LARGEST_UINT = 2**32 - 1


def is_ip4(text: str) -> bool:
    """What ``inet_pton`` takes: four decimal numbers without leading zeros."""
    return is_plain_address(text, 4)


def is_ip6(text: str) -> bool:
    return is_plain_address(text, 6)


def boolean(text: str) -> bool | None:
    """The truth value of netplan's own boolean words, in any case."""
    word = text.lower()
    return True if word in TRUE else False if word in FALSE else None


def unsigned(text: str) -> int | None:
    """What ``strtoull`` reads when it must read everything; an empty text is 0."""
    if not text:
        return 0
    match = DIGITS.match(text)
    if match is None or match.end() != len(text) or len(text) > 20:
        return None
    value = int(match[1])
    if text.lstrip("\t\n\v\f\r ").startswith("-"):
        value = -value % 2**64
    return value if value <= LARGEST_UINT else None


def leading_number(text: str) -> int:
    """What ``strtoull`` reads from the start, ignoring the rest."""
    match = DIGITS.match(text)
    return int(match[1][:20]) if match else 0


def address(text: str, *, zero_prefix: bool = False) -> Fault | None:
    """Check an address with its prefix length."""
    host, slash, prefix = text.rpartition("/")
    if not slash:
        return Fault(Code.PREFIX_LENGTH, "has no prefix length")
    length = leading_number(prefix)
    if is_ip4(host):
        longest = PREFIX_LENGTH[4]
    elif is_ip6(host):
        longest = PREFIX_LENGTH[6]
    else:
        return Fault(Code.ADDRESS, "is not an IPv4 or IPv6 address")
    if length > longest or (length == 0 and not zero_prefix):
        return Fault(Code.PREFIX_LENGTH, f"has a prefix length that is not in 1..{longest}")
    return None


def network(text: str) -> Fault | None:
    host = text.rpartition("/")[0] if "/" in text else text
    known = is_ip4(host) or is_ip6(host)
    return None if known else Fault(Code.ADDRESS, "is not an IPv4 or IPv6 address or network")


def endpoint(text: str) -> Fault | None:
    """Check a WireGuard endpoint: host or address, colon, port."""
    if text.startswith("["):
        host, bracket, rest = text[1:].rpartition("]")
        _, colon, port = rest.rpartition(":")
        if not bracket:
            return Fault(Code.VALUE, "has no closing bracket")
    else:
        host, colon, port = text.rpartition(":")
    if len(text) < 3 or not colon:
        return Fault(Code.VALUE, "is not host:port")
    if leading_number(port) > HIGHEST_PORT:
        return Fault(Code.VALUE, "has a port above 65535")
    known = is_ip4(host) or is_ip6(host) or all(HOST_LABEL.match(label) for label in host.split("."))
    return None if known else Fault(Code.VALUE, "is not host:port")


def _expect(test: Callable[[str], bool], message: str, code: Code = Code.VALUE) -> Callable[[str], Fault | None]:
    return lambda text: None if test(text) else Fault(code, message)


CHECKS: dict[str, Callable[[str], Fault | None]] = {
    "string": lambda text: None,
    "id": lambda text: None,
    "member": lambda text: None,
    "bool": _expect(lambda text: boolean(text) is not None, "is not a boolean (true or false)"),
    "uint": _expect(lambda text: unsigned(text) is not None, "is not a number"),
    "byte": _expect(lambda text: (unsigned(text) or 0) <= 255 and unsigned(text) is not None, "is not in 0..255"),
    "priority": _expect(lambda text: (unsigned(text) or 0) <= 63 and unsigned(text) is not None, "is not in 0..63"),
    "macaddress": _expect(lambda text: bool(MAC.match(text)), "is not a MAC address XX:XX:XX:XX:XX:XX"),
    "name": _expect(lambda text: bool(NAME.match(text)), "is not an interface name"),
    "driver": _expect(lambda text: " " not in text, "contains a space; write several drivers as a sequence"),
    "ip4": _expect(is_ip4, "is not an IPv4 address", Code.ADDRESS),
    "ip6": _expect(is_ip6, "is not an IPv6 address", Code.ADDRESS),
    "ip": _expect(lambda text: is_ip4(text) or is_ip6(text), "is not an IPv4 or IPv6 address", Code.ADDRESS),
    "address": address,
    "allowed-ip": lambda text: address(text, zero_prefix=True),
    "network": network,
    "destination": lambda text: None if text == "default" else network(text),
    "endpoint": endpoint,
    "renderer": _expect(lambda text: text in ("networkd", "NetworkManager"), "is not a renderer", Code.RENDERER),
    "version": _expect(lambda text: leading_number(text) == 2, "is not 2", Code.VERSION),
}


def words_of(grammar: str) -> tuple[dict[str, str], bool]:
    """The words of ``a|b@1.0 (any case)`` with the release that brought them, and whether case counts."""
    any_case = grammar.endswith(" (any case)")
    pairs = (word.partition("@") for word in grammar.removesuffix(" (any case)").split("|"))
    return {word: since for word, _, since in pairs}, not any_case


def check(grammar: str, scalar: Scalar) -> tuple[Fault | None, str]:
    """What is wrong with the scalar, and the release that its value needs."""
    words, case = words_of(grammar)
    text = str(scalar.value)
    faults = []
    for word, since in words.items():
        if word in CHECKS:
            fault = CHECKS[word](text)
            if fault is None:
                return None, since
            faults.append(fault)
        elif text == word or (not case and text.lower() == word.lower()):
            return None, since
    reasons = [fault.detail for fault in faults]
    plain = [word for word in words if word not in CHECKS]
    if plain:
        reasons.append(f"not one of {', '.join(plain)}" if reasons else f"is not one of {', '.join(plain)}")
    return Fault(faults[0].code if faults else Code.VALUE, " and ".join(reasons)), ""
