"""The type of a scalar as rcl_yaml_param_parser takes it: C's strtoll and strtod decide, not YAML's schema."""

from __future__ import annotations

import re

from bringup_lint.model.params import Value
from bringup_lint.pattern import regex

TRUE = frozenset(("Y", "y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"))
FALSE = frozenset(("N", "n", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"))
BLANK = " \t\n\v\f\r"
STRING_TAG = "tag:yaml.org,2002:str"

_INTEGER = regex(r"([+-]?)(?:0[xX]([0-9a-fA-F]+)|0([0-7]*)|([1-9][0-9]*))\Z")
_DECIMAL = regex(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?\Z")
_HEXADECIMAL = regex(r"[+-]?0[xX](?:[0-9a-fA-F]+(?:\.[0-9a-fA-F]*)?|\.[0-9a-fA-F]+)(?:[pP][+-]?[0-9]+)?\Z")
_WORD = regex(r"[+-]?(?:inf|infinity|nan|nan\([0-9A-Za-z_]*\))\Z", re.I)
_YAML_WORD = regex(r"(?:\.(?:nan|NaN|NAN)|[+-]?\.(?:inf|Inf|INF))\Z")
_FIRST = frozenset("0123456789+-.iInN" + BLANK)
_SHORT = 18
"""Digits that surely fit 64 bits."""
SMALLEST = 2.2250738585072014e-308
"""The smallest normal double; what is rounded below it is out of range for strtod."""


def scalar(text: str, style: str = "", tag: str = "") -> Value:
    """``style`` is the sign that opens the scalar: a quote makes it a string, ``|`` and ``>`` do not."""
    text = text.partition("\0")[0] if "\0" in text else str(text)
    if tag == STRING_TAG or style in ("'", '"'):
        return Value("string", text)
    if text in TRUE:
        return Value("bool", True)
    if text in FALSE:
        return Value("bool", False)
    if text[:1] in _FIRST:
        stripped = text.lstrip(BLANK)
        number = integer(stripped)
        if number is not None:
            return Value("integer", number)
        real = double(stripped, text)
        if real is not None:
            return Value("double", real)
    return Value("string", text)


def integer(text: str) -> int | None:
    """As ``strtoll`` with base 0: ``0x`` is hexadecimal, a leading zero octal; None when it does not fit 64 bits."""
    if len(text) <= _SHORT and text.isascii() and text.isdecimal() and text[0] != "0":
        return int(text)
    match = _INTEGER.match(text)
    if match is None or len(text) > 400:
        return None
    sign, hexadecimal, octal, decimal = match.groups()
    if hexadecimal is not None:
        number = int(hexadecimal, 16)
    else:
        number = int(decimal) if decimal is not None else int(octal or "0", 8)
    number = -number if sign == "-" else number
    return number if -(2**63) <= number < 2**63 else None


def double(text: str, whole: str) -> float | None:
    """As ``strtod``: ``inf`` and ``nan`` need no dot; None when the number is out of range."""
    if _DECIMAL.match(text):
        return _in_range(float(text), text)
    if _YAML_WORD.match(whole):
        return float(whole.replace(".", ""))
    if _WORD.match(text):
        return float(text.partition("(")[0])
    if _HEXADECIMAL.match(text):
        try:
            return float.fromhex(text)
        except OverflowError:
            return None
    return None


def _in_range(number: float, text: str) -> float | None:
    if number in (float("inf"), float("-inf")):
        return None
    if abs(number) < SMALLEST:
        digits = re.split("[eE]", text)[0]
        if any(digit in "123456789" for digit in digits):
            return number if number and len(text) <= 400 and _is_exact(number, text) else None
    return number


def _is_exact(number: float, text: str) -> bool:
    """Whether a number is what its text says, and not the nearest to it."""
    from fractions import Fraction  # which loads three modules, for numbers that nearly nobody writes

    return Fraction(text) == Fraction(number)
