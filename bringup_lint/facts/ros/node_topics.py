"""The topics of public drivers and tools, by default."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import table


@cache
def published() -> frozenset[str]:
    """The names of those that they publish, without a slash in front."""
    return frozenset(row["name"].lstrip("/") for row in table("ros/node_topics") if row["role"] == "pub")
