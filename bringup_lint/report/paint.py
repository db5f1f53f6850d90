"""Colours for a terminal, or none."""

from __future__ import annotations

from collections.abc import Callable

Paint = Callable[[str, str], str]

_CODES = {
    "error": "1;91",
    "warning": "1;33",
    "info": "1;36",
    "mark": "1;94",
    "label": "94",
    "frame": "94",
    "strong": "1",
    "good": "1;32",
    "faint": "2",
    "code": "36",
}


def painter(colour: bool) -> Paint:
    """A function of a style (``error``, ``mark``, ``strong``, ...) and a text."""
    return _painted if colour else _plain


def _painted(style: str, text: str) -> str:
    return f"\x1b[{_CODES[style]}m{text}\x1b[0m" if text else text


def _plain(style: str, text: str) -> str:
    return text
