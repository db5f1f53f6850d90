"""What limits.conf grants to the user of a service, although PAM never sees a service."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.parsers.limits import Grant
from bringup_lint.parsers.limits import parse

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.robot import Robot

LIMIT_OF = {"rtprio": "LimitRTPRIO", "memlock": "LimitMEMLOCK", "nice": "LimitNICE"}
"""Items that real-time programs need, and the setting that grants them to a service."""


def granted_limits(unit: Unit, robot: Robot) -> Iterator[tuple[str, Grant]]:
    """The real-time items that the limits files grant to the user of a service, with the line that says so."""
    user = unit.get("User")
    if not user or user in ("root", "0"):
        return
    groups = {str(word) for word in (*unit.words("Group"), *unit.words("SupplementaryGroups"))} | _memberships(
        str(user), robot
    )
    for grants in robot.parsed(parse, robot.of_kind("limits-conf")):
        for grant in grants:
            if grant.item in LIMIT_OF and (
                grant.domain == user or (grant.domain.startswith("@") and grant.domain[1:] in groups)
            ):
                yield grant.item, grant


def _memberships(user: str, robot: Robot) -> set[str]:
    source = robot.tree.find("/etc/group")
    rows = (line.split(":") for line in source.text.splitlines()) if source else ()
    return {row[0] for row in rows if len(row) > 3 and user in row[3].split(",")}
