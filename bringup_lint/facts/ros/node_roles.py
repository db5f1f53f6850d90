"""What is known about the executables and components of common packages."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import table
from bringup_lint.facts.ros.distros import at_least
from bringup_lint.named_tuple import NamedTuple

ABSOLUTE = frozenset(("tf", "tf_static"))
"""tf2 publishes these by absolute names, whatever the table says."""
HARDWARE = ("driver", "hardware")


class Role(NamedTuple):
    role: str
    """``driver``, ``hardware``, ``planning``, ``lifecycle manager``, ...; empty when it is not known."""
    managed: bool | None
    """Whether it is a lifecycle node; None when that is not known, or depends on an unknown distribution."""
    topics: frozenset[str] = frozenset()
    """Relative names of topics that it is known to use."""


@cache
def _rows() -> dict[tuple[str, str], dict[str, str]]:
    rows = {}
    for row in table("ros/lifecycle_nodes"):
        for program in (row["executable"], row["plugin"]):
            if program:
                rows[row["package"], program] = row
    return rows


@cache
def packages() -> frozenset[str]:
    """The packages that the table knows."""
    return frozenset(row["package"] for row in table("ros/lifecycle_nodes"))


def is_driver(package: str) -> bool:
    """Whether a package is known as the driver of a device."""
    return package in _drivers()


@cache
def _drivers() -> frozenset[str]:
    return frozenset(row["package"] for row in table("ros/lifecycle_nodes") if row["role"] in HARDWARE)


def role_of(package: str | None, program: str | None, distribution: str | None) -> Role:
    """``program``: an executable or a component class."""
    row = _rows().get((package or "", program or ""))
    if row is None:
        return Role("", None)
    managed: bool | None = {"yes": True, "no": False}.get(row["managed"])
    if row["managed"].startswith("yes from "):
        managed = at_least(distribution, row["managed"].split()[2].rstrip(","))
    words = (entry.split() for entry in row["topics_qos"].split(";"))
    topics = frozenset(
        word[1] for word in words if len(word) > 1 and word[0] in ("pub", "sub") and word[1][0] not in "/~"
    )
    return Role(row["role"], managed, topics - ABSOLUTE)


@cache
def lifecycle_names() -> frozenset[str]:
    """Executables of nav2's lifecycle nodes whose node is called like the executable."""
    rows = (
        row for row in table("ros/lifecycle_nodes") if row["package"].startswith("nav2_") and row["managed"] == "yes"
    )
    return frozenset(row["executable"] for row in rows) - {"map_saver_server", "nav2_costmap_2d"}
