"""Booleans, integers, sizes and shares."""

from __future__ import annotations

from bringup_lint.pattern import regex

TRUE = frozenset(("1", "yes", "y", "true", "t", "on"))
FALSE = frozenset(("0", "no", "n", "false", "f", "off"))
_BLANKS = " \t\n\r"
_SUFFIXES = ("E", "P", "T", "G", "M", "K", "B", "")
_SIZE = regex(r"[ \t\n\r]*\+?([0-9]+)(?:\.([0-9]*))?[ \t\n\r]*")
_INTEGER = regex(r"[ \t\n\r]*([+-]?)(0[xX][0-9a-fA-F]+|0[bB][01]+|0[oO][0-7]+|[0-9]+)")


def parse_bool(text: str) -> bool | None:
    """None when the text is no boolean."""
    word = text.lower()
    if word in TRUE:
        return True
    return False if word in FALSE else None


def parse_integer(text: str) -> int | None:
    """Decimal, or hexadecimal, octal and binary with their prefixes, as strtol() with base 0 reads it."""
    found = _INTEGER.fullmatch(text)
    if found is None:
        return None
    digits = found[2].lower()
    if digits[:2] in ("0x", "0b", "0o"):
        value = int(digits[2:], {"x": 16, "b": 2, "o": 8}[digits[1]])
    elif len(digits) > 1 and digits[0] == "0":
        if not all(digit in "01234567" for digit in digits):
            return None
        value = int(digits, 8)
    else:
        value = int(digits)
    return -value if found[1] == "-" else value


def parse_size(text: str, base: int = 1024) -> int | None:
    """Bytes; ``base`` is 1024 (memory) or 1000 (bandwidth). None when systemd would reject the text."""
    total = 0
    rest = text
    allowed = 0
    while True:
        found = _SIZE.match(rest)
        if found is None:
            return None
        rest = rest[found.end() :]
        step = next((i for i in range(allowed, len(_SUFFIXES)) if rest.startswith(_SUFFIXES[i])), None)
        if step is None:
            return None
        factor: int = base ** max(6 - step, 0)
        fraction = found[2] or "0"
        whole: int = 10 ** len(fraction)
        total += int(found[1]) * factor + int(fraction) * factor // whole
        if total >= 2**64:
            return None
        rest = rest[len(_SUFFIXES[step]) :]
        if not rest:
            return total
        allowed = step + 1


def parse_share(text: str) -> float | None:
    """Per cent of a value in ``%``, ``‰`` or ``‱``, with up to two places (one for ‰, none for ‱)."""
    for sign, places, scale in (("‱", 0, 100.0), ("‰", 1, 10.0), ("%", 2, 1.0)):
        if text.endswith(sign):
            whole, dot, fraction = text[: -len(sign)].partition(".")
            if dot and not (fraction.isdecimal() and 0 < len(fraction) <= places):
                return None
            value = parse_integer(whole)
            if value is None or value < 0:
                return None
            return (value + (int(fraction) / 10 ** len(fraction) if fraction else 0)) / scale
    return None


def parse_mode(text: str) -> int | None:
    """Permission bits, octal."""
    digits = text.lstrip(_BLANKS)
    if not digits or not all(digit in "01234567" for digit in digits):
        return None
    mode = int(digits, 8)
    return mode if mode <= 0o7777 else None
