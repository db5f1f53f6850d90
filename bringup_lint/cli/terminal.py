"""What standard output is: how wide, and whether it has colour. Nothing heavy is imported here."""

from __future__ import annotations

import os
import sys


def terminal_width() -> int:
    """Columns to set text in: COLUMNS, else the terminal's, at most 100; 80 where there is no terminal."""
    given = os.environ.get("COLUMNS", "")
    if given.isdecimal() and int(given[:4]):
        return min(int(given[:4]), 100)
    try:
        return min(os.get_terminal_size(sys.__stdout__.fileno() if sys.__stdout__ else -1).columns or 80, 100)
    except (OSError, ValueError, AttributeError):
        return 80


def wants_colour(forced: bool | None) -> bool:
    """Whether standard output gets colour: the option, else FORCE_COLOR, NO_COLOR, and whether it is a terminal."""
    if forced is not None:
        return forced
    if os.environ.get("NO_COLOR"):
        return False
    return bool(os.environ.get("FORCE_COLOR")) or (is_terminal() and os.environ.get("TERM") != "dumb")


def is_terminal() -> bool:
    return sys.stdout is not None and sys.stdout.isatty()
