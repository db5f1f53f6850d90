"""Whether a launched node of a public package sends and takes velocities with a time stamp."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.parameters import GivenParameters
    from bringup_lint.source import Span

TWIST, STAMPED = "geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped"
NONE, NEEDED = "none", "needed"


class Switch(NamedTuple):
    parameter: str
    default: str
    """``true``, ``false``, ``none`` where there is no such parameter, ``needed`` where the node may end without it."""


def switch(package: str, distribution: str | None) -> Switch | None:
    """What decides for the nodes of a package in a distribution; None when that is not known."""
    for row in table("ros/velocity_types"):
        if row["package"] == package and distribution in row["distributions"].split():
            return Switch(row["parameter"], row["default"])
    return None


def velocity_type(package: str, distribution: str | None, given: GivenParameters) -> tuple[str | None, Span | None]:
    """The type of velocities, and the value that decides it; None when they are not known."""
    found = switch(package, distribution)
    if found is None:
        return None, None
    if found.default == NONE:
        return TWIST, None
    if found.parameter in given.values:
        value, where = given.values[found.parameter]
        return ((STAMPED if value else TWIST), where) if isinstance(value, bool) else (None, None)
    return (None if given.open else {"true": STAMPED, "false": TWIST}.get(found.default)), None
