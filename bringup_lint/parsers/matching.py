"""Patterns at a place of a text."""

from __future__ import annotations

import re


def end_of(pattern: re.Pattern[str], text: str, at: int) -> int:
    """Where the match of a pattern at a place ends; the place itself where nothing matches."""
    found = pattern.match(text, at)
    return at if found is None else found.end()
