"""The environment variables that ROS 2 and its middlewares read."""

from __future__ import annotations

from functools import cache

from bringup_lint import facts
from bringup_lint.spelling import Neighbours
from bringup_lint.spelling import is_slip

_SHORTEST = 8
"""Letters of a name: a shorter one may be that of another variable."""


@cache
def variables() -> dict[str, str]:
    """Name to what its value is: ``domain``, ``rmw``, ``file``, or empty."""
    return {row["name"]: row["value"] for row in facts.table("ros/variables")}


def misspelt(name: str) -> str | None:
    """The variable of which a name differs in one letter that the hand left out, wrote twice or exchanged; not the
    first, without which it is that of another: ``OS_VERSION``."""
    found = [each for each in _slips().meant(name) if len(each) >= _SHORTEST and is_slip(name, each)]
    if len(found) != 1 or name[0] != found[0][0] or name.rstrip("S") == found[0].rstrip("S"):
        return None
    return found[0]


@cache
def _slips() -> Neighbours:
    return Neighbours(variables())
