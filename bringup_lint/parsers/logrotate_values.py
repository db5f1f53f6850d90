"""The values of logrotate directives, judged as logrotate's own reader does (config.c, 3.21)."""

from __future__ import annotations

from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem

SPACE = " \t\n\v\f\r"
_NUMBER = regex(r"[ \t\v\f\r]*([+-]?)(?:0[xX][0-9a-fA-F]+|0[0-7]*|[1-9][0-9]*)")
_MODE = regex(r"\s*[+-]?[0-7]+")
_WEEKDAY = regex(r"[ \t\v\f\r]*\+?0*[0-7]")


def check_value(kind: str, value: Located) -> Problem | None:
    """What is wrong with a value that is there; None when logrotate takes it."""
    code = _CHECKS[kind](value) if kind in _CHECKS else ""
    return Problem(code, value) if code else None


def _number(value: str) -> str:
    found = _NUMBER.fullmatch(value)
    return "" if found and found[1] != "-" else "bad-number"


def _rotations(value: str) -> str:
    found = _NUMBER.fullmatch(value)
    return "" if found and (found[1] != "-" or int(value, 0) >= -1) else "bad-number"


def _size(value: str) -> str:
    number = value[:-1] if value[-1] in "kKMG" else value
    if number == value and value[-1] not in "0123456789":
        return "unknown-unit"
    found = _NUMBER.fullmatch(number)
    return "" if not number or (found and found[1] != "-") else "bad-size"


def _weekday(value: str) -> str:
    return "" if not value or _WEEKDAY.fullmatch(value) else "bad-weekday"


def _address(value: str) -> str:
    return "" if all(" " < char <= "~" for char in value) else "bad-address"


def _path(value: str) -> str:
    return "" if all(char.isprintable() and not char.isspace() for char in value) else "bad-path"


def _options(value: str) -> str:
    words = split_words(Located(value, None))  # type: ignore[arg-type]
    return "" if words else "bad-options"


def owners(kind: str, value: Located) -> tuple[Located | None, Located | None, bool]:
    """User and group of ``create``, ``createolddir`` or ``su``, and whether there are words too many."""
    mode = _MODE.match(value) if kind == "owner" else None
    names = list(value.part(mode.end() if mode else 0, len(value)).words())
    user, group = (*names[:2], None, None)[:2]
    return user, group, len(names) > 2


def split_words(text: Located) -> list[Located] | None:
    """Words with quotes and backslashes, as popt splits them; None when a quote or backslash is left open."""
    words: list[Located] = []
    start: int | None = None
    letters: list[str] = []
    quote = ""
    at = 0
    while at < len(text):
        char = str.__getitem__(text, at)
        if quote:
            if char == quote:
                quote = ""
            else:
                if char == "\\":
                    at += 1
                    if at == len(text):
                        return None
                    if str.__getitem__(text, at) != quote:
                        letters.append("\\")
                letters.append(str.__getitem__(text, at))
        elif char in SPACE:
            if letters:
                words.append(_word(text, start or 0, at, letters))
            start, letters = None, []
        else:
            start = at if start is None else start
            if char in "\"'":
                quote = char
            elif char == "\\":
                at += 1
                if at == len(text):
                    return None
                letters.append(str.__getitem__(text, at))
            else:
                letters.append(char)
        at += 1
    if letters:
        words.append(_word(text, start or 0, len(text), letters))
    return words


def _word(text: Located, start: int, end: int, letters: list[str]) -> Located:
    plain = "".join(letters)
    if text.span is None:
        return Located(plain, text.span)
    place = text.part(start, end)
    return place if place == plain else Located(plain, place.span)


_CHECKS = {
    "number": _number,
    "rotations": _rotations,
    "size": _size,
    "weekday": _weekday,
    "address": _address,
    "path": _path,
    "options": _options,
}
