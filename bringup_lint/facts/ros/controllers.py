"""What controllers of ros2_controllers need to be configured."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple


class ControllerNeeds(NamedTuple):
    parameters: tuple[tuple[str, ...], ...]
    """Names and patterns of parameters, one of each group."""
    positive: frozenset[str]
    """Those that must be above 0."""


@cache
def controller_needs() -> dict[str, ControllerNeeds]:
    """By class, as ``diff_drive_controller/DiffDriveController``."""
    found: dict[str, ControllerNeeds] = {}
    for row in table("ros/controller_needs"):
        words = row["parameters"].split()
        found[row["class"]] = ControllerNeeds(
            tuple(tuple(word.lstrip(">").split("|")) for word in words),
            frozenset(word[1:] for word in words if word.startswith(">")),
        )
    return found
