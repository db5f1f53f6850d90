"""Releases of Debian and Ubuntu whose packages have moved to an archive (table ``host/ended_releases``)."""

from __future__ import annotations

from functools import lru_cache

from bringup_lint.facts import rows
from bringup_lint.named_tuple import NamedTuple


class EndedRelease(NamedTuple):
    codename: str
    distribution: str
    """``debian`` or ``ubuntu``."""
    number: str
    moved: str
    """The month in which its packages were moved (``2025-07``)."""


@lru_cache
def ended_releases() -> tuple[EndedRelease, ...]:
    return tuple(EndedRelease(*row) for row in rows("host/ended_releases")[1])
