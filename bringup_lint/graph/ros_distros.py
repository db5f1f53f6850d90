"""ROS distributions in the order of their release."""

from __future__ import annotations

ORDER = ("foxy", "galactic", "humble", "iron", "jazzy", "kilted", "lyrical", "rolling")
"""REP 2000."""


def at_least(distro: str | None, first: str) -> bool | None:
    """Whether a distribution is ``first`` or newer; None when it is not known."""
    if distro not in ORDER:
        return None
    return ORDER.index(distro) >= ORDER.index(first)
