"""The DDS libraries in the versions that a ROS distribution brings."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.facts.ros import distros
from bringup_lint.parsers import cyclonedds
from bringup_lint.parsers import fastdds

SERIES = {"2.1": "2.6", "2.3": "2.6", "2.10": "2.14"}
"""The series whose table is used for one that has none."""


@dataclass(frozen=True)
class Library:
    """A DDS library in the version that the robot runs."""

    name: str
    version: str
    known: bool
    """Whether the tree shows the ROS distribution; else the version is assumed."""
    why: str

    def __str__(self) -> str:
        return f"{self.name} {self.version}" + ("" if self.known else " (assumed)")


def cyclonedds_of(distro: str | None) -> Library:
    return _library("Cyclone DDS", "cyclonedds", distro, cyclonedds.DEFAULT_VERSION)


def fastdds_of(distro: str | None) -> Library:
    return _library("Fast DDS", "fastdds", distro, fastdds.DEFAULT_VERSION)


def _library(name: str, column: str, distro: str | None, default: str) -> Library:
    known = distros.every().get(distro or "")
    version = getattr(known, column) if known else ""
    if version:
        return Library(name, version, True, f"ROS {distro}")
    return Library(name, default, False, "no ROS distribution is known")
