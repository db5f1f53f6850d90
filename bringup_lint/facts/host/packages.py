"""Packages of apt that many robots install, and which of them a misspelt name means."""

from __future__ import annotations

from functools import cache

from bringup_lint import facts
from bringup_lint.spelling import Neighbours


@cache
def packages() -> Neighbours:
    return Neighbours(row["name"] for row in facts.table("host/packages"))


@cache
def near_packages() -> frozenset[str]:
    """Packages whose names differ in a letter from one of these."""
    return frozenset(near for row in facts.table("host/packages") for near in row["near"].split())
