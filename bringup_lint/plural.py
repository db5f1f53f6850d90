"""Numbers of things in text."""

from __future__ import annotations


def counted(count: int, thing: str) -> str:
    """``1 file``, ``2 files``; for things whose plural takes an s."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def of_severity(count: int, severity: str) -> str:
    """``2 errors``, and ``2 info``."""
    return f"{count} {severity}" if severity == "info" else counted(count, severity)
