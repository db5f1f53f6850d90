"""What Cyclone DDS accepts as a value: the ``uf_*`` functions of its ddsi_config.c."""

from __future__ import annotations

import re

from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Fault
from bringup_lint.model.schema import Item
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cyclonedds_schema import bare_unit
from bringup_lint.pattern import regex

DURATIONS = {
    "ns": 1,
    "us": 1_000,
    "ms": 1_000_000,
    "s": 1_000_000_000,
    "min": 60_000_000_000,
    "hr": 3_600_000_000_000,
    "day": 86_400_000_000_000,
}
"""Nanoseconds."""
SIZES = {"B": 1, "KiB": 1 << 10, "kB": 1 << 10, "MiB": 1 << 20, "MB": 1 << 20, "GiB": 1 << 30, "GB": 1 << 30}
"""Bytes; ``kB`` is 1024 bytes, as ``KiB``."""
_BITS = {"": 1, "K": 1 << 10, "k": 10**3, "M": 10**6, "Mi": 1 << 20, "G": 10**9, "Gi": 1 << 30}
THREADS = ("recv", "tev", "gc", "lease", "dq.builtins", "xmit.user", "dq.user", "debmon", "fsm")
"""The names a Thread may have."""

_INTEGER = regex(r"[ \t\n\v\f\r]*([+-]?[0-9]+)")
_REAL = regex(
    r"[ \t\n\v\f\r]*([+-]?(?:0[xX](?:[0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)(?:[pP][+-]?[0-9]+)?"
    r"|(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?|(?i:inf(?:inity)?|nan)))"
)
_RANGE = regex(r"(-?[0-9]+)\.\.(-?[0-9]+)$")
_INT64 = (1 << 63) - 1


def fault_of(item: Item, text: str, version: str) -> Fault | None:
    """What the library has against a value; None when it takes it silently."""
    check = _CHECKS.get(item.type)
    return check(item, text, version) if check else None


def words(item: Item) -> list[str]:
    """The words that an item takes."""
    found: list[str] = []
    for part in item.allowed.split(" | "):
        if part.startswith("comma-separated "):
            found += part.removeprefix("comma-separated ").split(",")
        elif ".." not in part:
            found += part.split("|")
    return [word for word in found if word]


def size(text: str) -> int | None:
    """A memory size in bytes; None when it is not one."""
    number = _quantity(text, SIZES, 1)
    return None if isinstance(number, Fault) else number.value


def duration(text: str, bare: str) -> int | None:
    """A duration in nanoseconds; None when it is not one or infinite."""
    number = _quantity(text, DURATIONS, DURATIONS.get(bare, 0))
    return None if isinstance(number, Fault) else number.value


def _word(item: Item, text: str, version: str) -> Fault | None:
    if text.lower() in words(item):
        return None
    return Fault(Code.VALUE, text)


def _list(item: Item, text: str, version: str) -> Fault | None:
    alone = [word for part in item.allowed.split(" | ") if not part.startswith("comma") for word in part.split("|")]
    listed = words(item)
    if text.lower() in alone or "addresses" in listed or not text:
        return None
    for part in text.split(","):
        if not _in_list(part, listed, version):
            return Fault(Code.VALUE, part)
    return None


def _in_list(part: str, listed: list[str], version: str) -> bool:
    if "integers" in listed:
        return _integer(part, 0, (1 << 32) - 1, version) is None
    if listed[0].startswith("1.N"):
        return re.fullmatch(r"1\.([1-9]|[12][0-9]|3[0-2])", part) is not None
    return part.removeprefix("-").lower() in listed


def _int(item: Item, text: str, version: str) -> Fault | None:
    if text.lower() in words(item):
        return None
    limits = next(filter(None, map(_RANGE.match, item.allowed.split(" | "))), None)
    if limits is None:
        return None
    low, high = int(limits[1]), int(limits[2])
    if words(item) == ["default"]:
        # sscanf("%d"): the whole text counts, and an overflow wraps around
        match = _INTEGER.match(text)
        return None if match and match.end() == len(text) else Fault(Code.VALUE, text)
    return _integer(text, low, high, version)


def _integer(text: str, low: int, high: int, version: str) -> Fault | None:
    match = _INTEGER.match(text)
    rest = text[match.end() :] if match else text
    if match is None or (rest.strip(" ") if version == "11" else rest):
        return Fault(Code.VALUE, text)
    value = int(match[1][:25])
    if version != "11" and value < 0 and low == 0 and high == (1 << 32) - 1:
        # strtoul: a negative number wraps around
        value = (1 << 64) + value if -value < (1 << 64) else high + 1
    return None if low <= value <= high else Fault(Code.RANGE, f"{low} to {high}")


def _memsize(item: Item, text: str, version: str) -> Fault | None:
    if text.lower() in words(item):
        return None
    limits = re.search(r"([0-9]+)\.\.([0-9]+) B", item.allowed)
    high = int(limits[2]) if limits else (1 << 31) - 1
    return _within(_quantity(text, SIZES, 1), 0, high, "B", version)


def _duration(item: Item, text: str, version: str) -> Fault | None:
    if text.lower() in ("inf", "default") and text.lower() in item.allowed.split(" | "):
        return None
    low, high = 0, _INT64 - 1
    limits = re.search(r"([0-9]+)([a-z]*)\.\.([0-9]+)([a-z]+)", item.allowed)
    if limits:
        low = int(limits[1]) * DURATIONS.get(limits[2], 0)
        high = int(limits[3]) * DURATIONS[limits[4]]
    return _within(_quantity(text, DURATIONS, DURATIONS.get(bare_unit(item), 0)), low, high, bare_unit(item), version)


def _bandwidth(item: Item, text: str, version: str) -> Fault | None:
    units = {f"{prefix}{unit}": factor for prefix, factor in _BITS.items() for unit in ("b/s", "bps", "B/s", "Bps")}
    units |= {f"Ki{unit}": 1 << 10 for unit in ("b/s", "bps", "B/s", "Bps")}
    if text.startswith("inf"):
        rest = text[3:].strip(" ")
        return None if not rest or rest in units else Fault(Code.UNIT, rest)
    found = _quantity(text, units, 1)
    return found if isinstance(found, Fault) and found.fatal else None


class _Number(NamedTuple):
    value: int
    negative: bool
    bare: bool
    overflow: bool = False


def _quantity(text: str, units: dict[str, int], default: int) -> _Number | Fault:
    """A number with a unit: first as an integer, then as a real number, as the library tries it."""
    if text == "":
        return Fault(Code.VALUE, text)
    match = _INTEGER.match(text)
    if match:
        value = int(match[1][:25])
        factor, bare = _factor(text[match.end() :], value == 0, units, default)
        if factor:
            return _Number(value * factor, value < 0, bare, abs(value) > _INT64)
    match = _REAL.match(text)
    if match is None:
        return Fault(Code.VALUE, text)
    real = float.fromhex(match[1]) if "x" in match[1].lower() else float(match[1])
    rest = text[match.end() :]
    factor, bare = _factor(rest, real == 0, units, default)
    if not factor:
        return Fault(Code.UNIT, rest.lstrip(" "))
    if real != real or abs(real) * factor >= _INT64:
        return _Number(_INT64, real < 0, bare, True)
    scaled = int(abs(real) * factor + 0.5)
    return _Number(-scaled if real < 0 else scaled, real < 0, bare)


def _factor(unit: str, zero: bool, units: dict[str, int], default: int) -> tuple[int, bool]:
    unit = unit.lstrip(" ")
    if unit:
        return units.get(unit, 0), False
    return (1, False) if zero else (default, True)


def _within(number: _Number | Fault, low: int, high: int, bare: str, version: str) -> Fault | None:
    if isinstance(number, Fault):
        return number
    if number.overflow or not low <= number.value <= high:
        return Fault(Code.RANGE)
    return Fault(Code.BARE_NUMBER, bare, False) if number.bare else None


def _string(item: Item, text: str, version: str) -> Fault | None:
    if item.path == "CycloneDDS/Domain@Id":
        good = re.fullmatch(r"(?i:any)|[ \t\n\v\f\r]*\+?[0-9]+", text)
        return None if good and (not text[-1:].isdecimal() or int(text) < (1 << 32) - 1) else Fault(Code.VALUE, text)
    if item.path == "CycloneDDS/Domain/Threads/Thread@Name":
        return None if text in THREADS else Fault(Code.VALUE, text)
    return None


_CHECKS = {
    "bool": _word,
    "enum": _word,
    "list": _list,
    "int": _int,
    "memsize": _memsize,
    "duration": _duration,
    "bandwidth": _bandwidth,
    "string": _string,
}
