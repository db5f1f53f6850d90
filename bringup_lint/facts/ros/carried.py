"""Packages of which robots keep copies in their own trees."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import table


@cache
def names() -> frozenset[str]:
    return frozenset(row["package"] for row in table("ros/carried"))
