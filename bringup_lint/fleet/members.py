"""The robots of a fleet before their files are read, and what their inventory declares."""

from __future__ import annotations

import os

from bringup_lint.config import ConfigError
from bringup_lint.dataclass import dataclass
from bringup_lint.discover.reading import Unreadable
from bringup_lint.discover.reading import read_bytes

ROLE = "robot"
"""The role of a robot of which nothing says another."""


@dataclass(frozen=True)
class Member:
    """A robot, before its files are read."""

    name: str
    layers: tuple[str, ...]
    """Folders and archives; what a later one holds counts in place of what an earlier one does."""
    role: str = ROLE
    site: str = ""
    domain: int | None = None
    talks: str = ""
    delivered: tuple[tuple[str, str], ...] = ()
    """What playbooks copy to it: the place on the robot, and the file that comes there."""


@dataclass(frozen=True)
class Accepted:
    """What the inventory declares to be meant."""

    rule: str
    robots: tuple[str, ...] = ()
    """All when empty."""
    key: str = ""
    """What a difference is about, such as ``rover.service``; anything when empty."""
    reason: str = ""
    path: str = ""
    """The inventory that says so."""
    line: int = 1


@dataclass(frozen=True)
class Inventory:
    members: tuple[Member, ...]
    accepted: tuple[Accepted, ...] = ()


def refusal(place: str) -> str:
    """Why the files of a robot cannot lie there; empty when they can."""
    if not os.path.exists(place):
        return f"there is no '{place}'"
    return "" if os.path.isdir(place) or os.path.isfile(place) else f"'{place}' is neither a folder nor an archive"


def text_of(path: str) -> str:
    """Raises ConfigError."""
    try:
        return read_bytes(path, follow=True)[0].decode("utf-8")
    except (Unreadable, UnicodeDecodeError) as error:
        raise ConfigError(f"{path}: {error}") from error
