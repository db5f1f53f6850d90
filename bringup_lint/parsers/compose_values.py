"""The values of compose files, as compose-go and the Docker engine read them.

Sources: loader/interpolate.go, format/volume.go, types/duration.go, types/bytes.go and template/template.go of
compose-go; github.com/docker/go-connections/nat for ports.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterator

from bringup_lint.addresses import HIGHEST_PORT
from bringup_lint.addresses import is_address
from bringup_lint.model.compose import is_variable
from bringup_lint.model.compose import split
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Fault
from bringup_lint.model.schema import Item
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_DURATION = regex(r"[-+]?(?:(?:\d+(?:\.\d*)?|\.\d+)(?:ns|us|µs|μs|ms|s|m|h|d|w))+|0")
_SIZE = regex(r"(?:\d+(?:\.\d+)?|\.\d+) ?(?:[kmgtp](?:i?b)?|b)?|-1", re.I)
_TRUTH = frozenset("true false y yes on n no off".split())
_WHOLE = regex(r"[-+]?\d+")
_DECIMAL = regex(r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?")
_RESTART = regex(r"no|always|unless-stopped|on-failure(?::\d+)?|")
_PULL = regex(r"always|never|build|if_not_present|missing|refresh|daily|weekly|every_(?:\d+[wdhms])+")
_PROJECT = regex(r"[a-z0-9][a-z0-9_-]*")
_CONTAINER = regex(r"[a-zA-Z0-9][a-zA-Z0-9_.-]+")
_PORTS = regex(r"(?P<first>\d{1,5})(?:-(?P<last>\d{1,5}))?")
_PROTOCOL = regex(r"tcp|udp|sctp", re.I)
_PERMISSIONS = regex(r"[rwm]{1,3}")
_MAC = regex(r"(?:[0-9A-Fa-f]{2}(?:[:-][0-9A-Fa-f]{2}){5})?")
"""An empty one is not handed on to Docker."""
_SIGNAL = regex(r"(?:SIG)?[A-Z]+\d*(?:[-+]\d+)?|\d+")
_MOUNT_OPTIONS = frozenset(
    "ro rw nocopy z Z cached delegated consistent private rprivate shared rshared slave rslave U O".split()
)
_NAME = regex(r"[_a-zA-Z]\w*", re.ASCII)
_OPERATOR = regex(r":?[-+?]")


def fault(item: Item, text: Located) -> Fault | None:
    """What is wrong with a string at the place of an item; None where compose still puts something in."""
    if is_variable(text):
        return None
    words = item.allowed.split("|") if item.allowed and ".." not in item.allowed else []
    if words and text not in words:
        return Fault(Code.ENUM, f"is not one of {', '.join(words)}")
    check = _GRAMMARS.get(item.row.get("grammar", ""))
    return check(text) if check else None


def number_fault(item: Item, number: float) -> Fault | None:
    """What is wrong with a number that YAML reads as one."""
    low, dots, high = item.allowed.partition("..")
    if dots and ((low and number < float(low)) or (high and number > float(high))):
        return Fault(Code.RANGE, f"is not in the range {low or 'to'} to {high}" if high else f"is below {low}")
    return None


def _matches(pattern: re.Pattern[str], expected: str) -> Callable[[Located], Fault | None]:
    def check(text: Located) -> Fault | None:
        return None if pattern.fullmatch(text) else Fault(Code.VALUE, f"is not {expected}")

    return check


def _truth(text: Located) -> Fault | None:
    return None if text.lower() in _TRUTH else Fault(Code.BOOL, "is not a truth value")


def _address(text: Located) -> Fault | None:
    return None if is_address(text) else Fault(Code.ADDRESS, "is not an IP address")


def _port(text: Located) -> Fault | None:
    """``[[address:]host:]container[/protocol]``, where both ends may be ranges."""
    whole, slash, protocol = text.partition("/")
    if slash and not _PROTOCOL.fullmatch(protocol):
        return Fault(Code.VALUE, f"names the protocol '{protocol}': it is tcp, udp or sctp")
    front, _, container = whole.rpartition(":")
    host = front.rpartition(":")[2] if not front.endswith("]") else ""
    inside, outside = _range(container), _range(host)
    if inside is None:
        return Fault(Code.VALUE, f"has no container port: '{container}' is not a port")
    if host and outside is None:
        return Fault(Code.VALUE, f"has '{host}' as port of the host")
    if host and outside and inside != outside and inside > 1:
        return Fault(Code.VALUE, "has ranges of different length")
    return None


def _range(text: str) -> int | None:
    """The number of ports; None when this is no port or range of ports."""
    match = _PORTS.fullmatch(text)
    if match is None:
        return None
    first, last = int(match["first"]), int(match["last"] or match["first"])
    return last - first + 1 if first <= last <= HIGHEST_PORT else None


def _mount(text: Located) -> Fault | None:
    """``[source:]target[:options]``; the colon of a Windows drive is part of its path."""
    if not text:
        return Fault(Code.VALUE, "is empty")
    parts = split(text)
    if len(parts) > 1 and re.fullmatch(r"[A-Za-z]", parts[0]):
        parts = parts[1:]
    if not all(parts):
        return Fault(Code.VALUE, "has nothing between two colons")
    if len(parts) > 3:
        return Fault(Code.VALUE, "has too many colons")
    odd = [option for option in parts[2].split(",") if option not in _MOUNT_OPTIONS] if len(parts) == 3 else []
    return Fault(Code.IGNORED, odd[0], fatal=False) if odd else None


def _device(text: Located) -> Fault | None:
    """``host[:container[:permissions]]``, or the name of a CDI device."""
    parts = split(text)
    if len(parts) > 3:
        return Fault(Code.VALUE, "has too many colons")
    if len(parts) == 3 and not _PERMISSIONS.fullmatch(parts[2]):
        return Fault(Code.VALUE, f"has the permissions '{parts[2]}': they are made of r, w and m")
    return None


_GRAMMARS: dict[str, Callable[[Located], Fault | None]] = {
    "address": _address,
    "container-name": _matches(_CONTAINER, "a name of letters, digits, dots, dashes and underscores"),
    "decimal": _matches(_DECIMAL, "a number"),
    "device": _device,
    "duration": _matches(_DURATION, "a duration such as 30s or 1m30s"),
    "mac": _matches(_MAC, "a MAC address such as 02:42:ac:11:00:02"),
    "mount": _mount,
    "port": _port,
    "project-name": _matches(_PROJECT, "made of small letters, digits, dashes and underscores"),
    "pull-policy": _matches(_PULL, "one of always, missing, never, build, daily, weekly and every_<duration>"),
    "restart": _matches(_RESTART, "one of no, always, unless-stopped and on-failure[:count]"),
    "size": _matches(_SIZE, "a size such as 512m"),
    "stop-signal": _matches(_SIGNAL, "the name or the number of a signal"),
    "truth": _truth,
    "whole": _matches(_WHOLE, "a whole number"),
}


def bad_substitutions(text: Located) -> Iterator[Located]:
    """The ``${`` that compose cannot read: it stops with "invalid interpolation format"."""
    at = text.find("$")
    while 0 <= at < len(text) - 1:
        if text[at + 1] != "{":
            at = text.find("$", at + (2 if text[at + 1] == "$" else 1))
            continue
        name = _NAME.match(text, at + 2)
        operator = _OPERATOR.match(text, name.end()) if name else None
        end = _closing(text, at + 2)
        if name is None or end is None or (operator is None and name.end() != end):
            yield text.part(at, min(len(text), (end or at + 1) + 1))
            return
        if operator is not None:
            yield from bad_substitutions(text.part(operator.end(), end))
        at = text.find("$", end)


def _closing(text: str, at: int) -> int | None:
    """The brace that closes a substitution, on the same line."""
    depth = 1
    for end in range(at, len(text)):
        if text[end] == "\n":
            return None
        if text[end] == "{" and text[end - 1] == "$":
            depth += 1
        elif text[end] == "}":
            depth -= 1
            if not depth:
                return end
    return None
