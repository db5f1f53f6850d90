"""The environment variables that ROS 2 and its middlewares read."""

from __future__ import annotations

from functools import cache

from bringup_lint import facts


@cache
def variables() -> dict[str, str]:
    """Name to what its value is: ``domain``, ``rmw``, ``file``, or empty."""
    return {row["name"]: row["value"] for row in facts.table("ros/variables")}
