"""Calendar events, as systemd.time(7) has them: whether OnCalendar= takes a text."""

from __future__ import annotations

import re

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

SHORTHANDS = frozenset(
    [
        "minutely",
        "hourly",
        "daily",
        "weekly",
        "monthly",
        "quarterly",
        "yearly",
        "annually",
        "anually",
        "biannually",
        "bi-annually",
        "semiannually",
        "semi-annually",
    ]
)
_DAYS = ("mon", "tue", "wed", "thu", "fri", "sat", "sun")
_DAY = regex(
    r"(mon(?:day)?|tue(?:sday)?|wed(?:nesday)?|thu(?:rsday)?|fri(?:day)?|sat(?:urday)?|sun(?:day)?)"
    r"(?=[-., ]|$)",
    re.IGNORECASE,
)
_TIMEZONE = regex(r"[A-Z][A-Za-z0-9_+-]*(/[A-Za-z0-9_+-]+)*")
_NUMBER = regex(r"[0-9]+")
_SECONDS = regex(r"[0-9]+(\.(?!\.)[0-9]+)?")
_MICRO = 1_000_000
_LAST_SECOND = 7_258_118_399
"""The end of 2199."""


class _Reject(Exception):
    pass


class _Part(NamedTuple):
    start: int
    stop: int
    repeat: int


def is_calendar(text: str) -> bool:
    """Whether systemd accepts the text as a calendar event."""
    head, _, zone = text.rpartition(" ")
    if head and _is_timezone(zone):
        text = head
    if not text:
        return False
    if text.lower() in SHORTHANDS:
        return True
    try:
        return _parse(text)
    except _Reject:
        return False


def _is_timezone(word: str) -> bool:
    """UTC, or a word shaped like a name of the time zone database (which is not asked)."""
    if word.upper() == "UTC":
        return True
    return _TIMEZONE.fullmatch(word) is not None and _DAY.fullmatch(word) is None and word.lower() not in SHORTHANDS


def _parse(text: str) -> bool:
    rest = _weekdays(text)
    if rest.startswith("@"):
        return rest[1:].isdecimal() and int(rest[1:]) <= _LAST_SECOND
    rest = _date(rest)
    return not rest or _time(rest)


def _weekdays(text: str) -> str:
    rest = text
    opened = -1
    first = True
    while True:
        found = _DAY.match(rest)
        if found is None:
            if first and not re.match(r"(mon|tue|wed|thu|fri|sat|sun)", rest, re.IGNORECASE):
                return rest
            raise _Reject
        day = _DAYS.index(found[1][:3].lower())
        if opened > day:
            raise _Reject
        rest = rest[found.end() :]
        if not rest or rest[0] == " ":
            return rest.lstrip(" ")
        if rest[0] == ",":
            opened, rest = -1, rest[1:]
        else:
            if opened >= 0 or (rest[0] == "." and not rest.startswith("..")):
                raise _Reject
            opened, rest = day, rest[2:] if rest[0] == "." else rest[1:]
        if not rest or rest[0] == " ":
            if opened >= 0:
                raise _Reject
            return rest.lstrip(" ")
        first = False


def _number(text: str, seconds: bool) -> tuple[int, str]:
    found = (_SECONDS if seconds else _NUMBER).match(text)
    if found is None:
        raise _Reject
    value = round(float(found[0]) * _MICRO) if seconds else int(found[0])
    if value > 2**31 - 1:
        raise _Reject
    return value, text[found.end() :]


def _chain(text: str, seconds: bool = False) -> tuple[list[_Part], str]:
    if text.startswith("*"):
        rest = text[1:]
        return [], rest
    parts = []
    while True:
        start, rest = _number(text, seconds)
        stop, repeat = -1, 0
        if rest.startswith(".."):
            stop, rest = _number(rest[2:], seconds)
            repeat = _MICRO if seconds else 1
        if rest.startswith("/"):
            repeat, rest = _number(rest[1:], seconds)
            if repeat == 0:
                raise _Reject
        elif seconds and stop >= 0 and start + repeat > stop:
            raise _Reject
        if rest and rest[0] not in " ,-~:":
            raise _Reject
        parts.append(_Part(start, stop, repeat))
        if not rest.startswith(","):
            return parts, rest
        text = rest[1:]


def _valid(parts: list[_Part], low: int, high: int, from_end: bool = False) -> None:
    high -= 3 if from_end else 0
    for start, stop, repeat in parts:
        if stop > start and repeat > 0:
            stop -= (stop - start) % repeat
        if start == stop or (stop > start and repeat > 0 and start + repeat > stop):
            repeat, stop = 0, -1
        if not low <= start <= high or repeat > high - low:
            raise _Reject
        if stop >= 0:
            if not low <= stop <= high or start + repeat > stop:
                raise _Reject
        elif (start - repeat < low) if from_end else (start + repeat > high):
            raise _Reject


def _date(text: str) -> str:
    if not text:
        return text
    first, rest = _chain(text)
    if not rest or rest[0] == ":":
        return text
    from_end = rest[0] == "~"
    if rest[0] not in "-~":
        raise _Reject
    second, rest = _chain(rest[1:])
    if not rest or rest[0] == " ":
        _valid(first, 1, 12)
        _valid(second, 1, 31, from_end)
        return rest.lstrip(" ")
    if from_end or rest[0] not in "-~":
        raise _Reject
    from_end = rest[0] == "~"
    third, rest = _chain(rest[1:])
    if rest and rest[0] != " ":
        raise _Reject
    _valid([_Part(_year(a), _year(b), c) for a, b, c in first], 1970, 2199)
    _valid(second, 1, 12)
    _valid(third, 1, 31, from_end)
    return rest.lstrip(" ")


def _year(value: int) -> int:
    if 0 <= value < 70:
        return value + 2000
    return value + 1900 if 70 <= value < 100 else value


def _time(text: str) -> bool:
    hours, rest = _chain(text)
    if not rest.startswith(":"):
        raise _Reject
    minutes, rest = _chain(rest[1:])
    seconds: list[_Part] = []
    if rest:
        if rest[0] != ":":
            raise _Reject
        seconds, rest = _chain(rest[1:], seconds=True)
    _valid(hours, 0, 23)
    _valid(minutes, 0, 59)
    _valid(seconds, 0, 60 * _MICRO - 1)
    return not rest
