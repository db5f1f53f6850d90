"""Misspelt words."""

from __future__ import annotations

from bringup_lint.spelling import nearest

__all__ = [
    "nearest",
]
