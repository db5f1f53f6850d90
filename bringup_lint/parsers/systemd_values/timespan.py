"""Time spans, as systemd.time(7) has them."""

from __future__ import annotations

import math

from bringup_lint.pattern import regex

_UNITS: tuple[tuple[str, float], ...] = (
    ("seconds", 1.0), ("second", 1.0), ("sec", 1.0), ("s", 1.0),
    ("minutes", 60.0), ("minute", 60.0), ("min", 60.0),
    ("months", 2629800.0), ("month", 2629800.0), ("M", 2629800.0),
    ("msec", 1e-3), ("ms", 1e-3), ("m", 60.0),
    ("hours", 3600.0), ("hour", 3600.0), ("hr", 3600.0), ("h", 3600.0),
    ("days", 86400.0), ("day", 86400.0), ("d", 86400.0),
    ("weeks", 604800.0), ("week", 604800.0), ("w", 604800.0),
    ("years", 31557600.0), ("year", 31557600.0), ("y", 31557600.0),
    ("usec", 1e-6), ("us", 1e-6), ("μs", 1e-6), ("µs", 1e-6),
)  # fmt: skip
_NANOSECONDS: tuple[tuple[str, float], ...] = (*_UNITS, ("nsec", 1e-9), ("ns", 1e-9))
_BLANKS = " \t\n\r"
_NUMBER = regex(r"([+]?)([0-9]*)(\.([0-9]*))?")
_MAXIMUM = 2**64 / 1e6


def parse_timespan(text: str, *, unit: float = 1.0, nanoseconds: bool = False) -> float | None:
    """Seconds, ``math.inf`` for ``infinity``, None when systemd would reject the text.

    ``unit`` is what a bare number counts, in seconds.
    """
    table = _NANOSECONDS if nanoseconds else _UNITS
    text = text.lstrip(_BLANKS)
    if text.startswith("infinity"):
        return math.inf if not text[8:].strip(_BLANKS) else None
    total = 0.0
    if not text:
        return None
    while text:
        found = _NUMBER.match(text)
        assert found is not None
        _, whole, dot, fraction = found.groups()
        if (not whole and (not dot or not fraction)) or (dot and not fraction):
            return None
        rest = text[found.end() :]
        bare = rest
        rest = rest.lstrip(_BLANKS)
        factor = unit
        for suffix, seconds in table:
            if rest.startswith(suffix):
                factor, rest = seconds, rest[len(suffix) :]
                break
        else:
            if bare and bare[0] not in _BLANKS:
                return None
        total += float(f"{whole or 0}.{fraction or 0}") * factor
        if total >= _MAXIMUM:
            return None
        text = rest.lstrip(_BLANKS)
    return total
