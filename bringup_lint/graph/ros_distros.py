"""ROS distributions in the order of their release."""

from __future__ import annotations

from datetime import date

from bringup_lint.facts import table

ORDER = ("foxy", "galactic", "humble", "iron", "jazzy", "kilted", "lyrical", "rolling")
"""REP 2000."""


def at_least(distro: str | None, first: str) -> bool | None:
    """Whether a distribution is ``first`` or newer; None when it is not known."""
    if distro not in ORDER:
        return None
    return ORDER.index(distro) >= ORDER.index(first)


def distro_end(distro: str | None) -> date | None:
    """The last day on which a distribution gets updates; None when it has no end or is not known."""
    row = next((row for row in table("ros_distro_ends") if row["distro"] == distro), None)
    return date.fromisoformat(row["end"]) if row else None
