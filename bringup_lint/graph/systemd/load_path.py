"""Where unit files lie, which directory wins, and which manager reads it (systemd.unit(5), "Unit File Load
Path")."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source

SYSTEM_PATH = (
    "/etc/systemd/system.control",
    "/run/systemd/system.control",
    "/run/systemd/transient",
    "/run/systemd/generator.early",
    "/etc/systemd/system",
    "/etc/systemd/system.attached",
    "/run/systemd/system",
    "/run/systemd/system.attached",
    "/run/systemd/generator",
    "/usr/local/lib/systemd/system",
    "/usr/lib/systemd/system",
    "/lib/systemd/system",
    "/run/systemd/generator.late",
)
USER_PATH = (
    "/.config/systemd/user.control",
    "/.config/systemd/user",
    "/etc/systemd/user",
    "/run/systemd/user",
    "/.local/share/systemd/user",
    "/usr/local/share/systemd/user",
    "/usr/local/lib/systemd/user",
    "/usr/lib/systemd/user",
    "/lib/systemd/user",
)
"""Directories in the order in which they win (systemd.unit(5), "Unit File Load Path")."""

_USER_FOLDER = regex(
    r"(?:^|/)(?:(?:systemd|units?|services?)[/_-]user|user[_-](?:systemd|units?|services?))(?:/|$)", 0, "user"
)


class Place(NamedTuple):
    """Where a file is: its overlay root or folder, the manager, and its rank in the load path (None:
    outside)."""

    root: str
    manager: str
    rank: int | None


def place_of(source: Source, folder: str | None = None) -> Place:
    """The place of a unit file, or of the ``.d`` or ``.wants`` folder that holds it."""
    path = source.robot_path
    if path is not None:
        directory = (folder or path).rpartition("/")[0]
        if directory in SYSTEM_PATH:
            return Place(_root(source, path), "system", SYSTEM_PATH.index(directory))
        for rank, suffix in enumerate(USER_PATH):
            if directory == suffix or (suffix.startswith("/.") and directory.endswith(suffix)):
                return Place(_root(source, path), "user", rank)
    directory = (source.name if folder is None else source.name.rpartition("/")[0]).rpartition("/")[0]
    manager = "user" if _USER_FOLDER.search(directory) else "system"
    return Place(directory, manager, None)


def _root(source: Source, path: str) -> str:
    """The overlay of a file; the folder of a file that is installed from another one."""
    inside = path.lstrip("/")
    return source.name.removesuffix(inside) if source.name.endswith(inside) else source.name.rpartition("/")[0]


def order(place: Place) -> int:
    """The rank in the load path; files outside of it come last."""
    return len(SYSTEM_PATH) if place.rank is None else place.rank
