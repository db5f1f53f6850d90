"""Prose in lines of a given width."""

from __future__ import annotations

from functools import lru_cache


def wrap(text: str, width: int) -> list[str]:
    """The lines of a text, broken at blanks; its own line ends are kept, long words stay whole, and items are
    indented below their first word."""
    return [line for paragraph in text.splitlines() for line in _broken(paragraph, max(width, 20))] or [""]


def _broken(paragraph: str, width: int) -> tuple[str, ...]:
    return (paragraph,) if len(paragraph) <= width else _set(paragraph, width)


@lru_cache(1000)
def _set(paragraph: str, width: int) -> tuple[str, ...]:
    """What many findings say alike is broken once."""
    from re import match
    from textwrap import wrap as wrapped

    mark = match(r"\s*(?:(?:\d+\.|[-*])\s+)?", paragraph)
    indent = " " * (mark.end() if mark else 0)
    return tuple(wrapped(paragraph, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False))
