"""Whether a directory will be there on the running robot, by everything that makes directories."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.roots import resolve_inside
from bringup_lint.facts import table
from bringup_lint.graph.systemd.provision import makes
from bringup_lint.graph.systemd.provision import mentions
from bringup_lint.parsers.systemd_values import expand
from bringup_lint.parsers.systemd_values import split_words
from bringup_lint.parsers.systemd_values import unit_specifiers
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.robot import Robot

DIRECTORIES = {
    "RuntimeDirectory": "/run",
    "StateDirectory": "/var/lib",
    "CacheDirectory": "/var/cache",
    "LogsDirectory": "/var/log",
    "ConfigurationDirectory": "/etc",
}
"""What systemd makes for a unit, and where; systemd.exec(5)."""

_MADE_BY_TMPFILES = frozenset("fFwdDvqQpLcbC")
_STATE = ("/var/log/", "/var/lib/", "/var/cache/", "/var/spool/", "/run/", "/var/run/", "/tmp/", "/var/tmp/")
"""Where nothing is unless somebody makes it."""
_VOLATILE = ("/run/", "/var/run/", "/tmp/", "/dev/", "/proc/", "/sys/")


def absolute(word: Located, unit: Unit) -> str | None:
    """A path of a unit file with its specifiers replaced; None when it is not known."""
    path = expand(word, unit_specifiers(unit.name))
    return posixpath.normpath(path) if path and path.startswith("/") and "$" not in path else None


def is_made(path: str, unit: Unit, robot: Robot) -> bool | None:
    """Whether something makes the path before the unit starts. False: nothing of the tree; None: unknown."""
    path = path.replace("/var/run/", "/run/", 1) if path.startswith("/var/run/") else path
    if any(made == path or made.startswith(f"{path}/") for made in _made(unit, robot)):
        return True
    if any(path.startswith(f"{mount}/") for mount in _mounts(robot)):
        return None
    if robot.tree.complete and robot.tree.root is not None and not path.startswith(_VOLATILE):
        there = is_there(path, robot)
        if there is not None:
            return there
    if any((source.robot_path or "").startswith(f"{path}/") for source in robot.sources) or mentions(robot.tree, path):
        return True
    return False if path.startswith(_STATE) else None


def is_there(path: str, robot: Robot) -> bool | None:
    """What a root file system says of a path; None when it is not whole there, or the path lies on another mount."""
    if any(path.startswith(f"{mount}/") for mount in _mounts(robot)):
        return None
    if resolve_inside(robot.tree.root, path) is not None:
        return True
    parts = path.split("/")
    top = "/".join(parts[:3]) if parts[1] == "home" else "/".join(parts[:2])
    return False if path != top and resolve_inside(robot.tree.root, top) is not None else None


def forgotten(path: str, robot: Robot) -> str | None:
    """A file of one's own that the repository ships for the same folder of the robot, when it ships and makes
    nothing at ``path``. Names that share their first word, and scripts, are one's own; the rest may come from
    elsewhere."""
    tree = robot.tree
    if tree.root is not None or tree.find(path) is not None or path.startswith(_VOLATILE):
        return None
    folder, _, name = path.rpartition("/")
    for shipped in tree.paths:
        found = tree.robot_path(shipped)
        if found and found.rpartition("/")[0] == folder and _related(name, found.rpartition("/")[2]):
            known = any(True for _ in tree.named(name)) or makes(tree, name) or mentions(tree, path)
            return None if known else found
    return None


def _related(name: str, other: str) -> bool:
    words = re.split(r"[-_.]", name)
    return name.endswith((".sh", ".bash")) or (len(words) > 1 and words[0] == re.split(r"[-_.]", other)[0])


def _made(unit: Unit, robot: Robot) -> Iterator[str]:
    yield from (row["path"] for row in table("host/base_directories"))
    for other in robot.units.all:
        yield from directories(other)
        if other.type == "mount" and (where := other.get("Where")):
            yield str(where)
    for source in robot.of_kind("tmpfiles"):
        for line in source.text.splitlines():
            words = line.split()
            if len(words) > 1 and words[0][:1] in _MADE_BY_TMPFILES:
                yield words[1].strip("\"'").rstrip("/")
    yield from _mounts(robot)
    yield from _presumed(unit, robot)


def directories(unit: Unit) -> Iterator[str]:
    """The directories that systemd makes for a unit."""
    for key, base in DIRECTORIES.items():
        for value in unit.values(key, unit.section):
            for word in split_words(value).words:
                name = expand(word.partition(":")[0], unit_specifiers(unit.name))
                if name:
                    yield f"{base}/{name}".rstrip("/")


def _mounts(robot: Robot) -> Iterator[str]:
    for fstab in robot.fstabs:
        for mount in fstab.mounts:
            if mount.target and mount.target.startswith("/") and mount.target != "/":
                yield mount.target.rstrip("/")


def _presumed(unit: Unit, robot: Robot) -> Iterator[str]:
    """What must be there for the unit to start at all."""
    folder = unit.get("WorkingDirectory")
    if folder and folder.startswith("/"):
        yield folder.rstrip("/")
    for process in robot.units.processes(unit):
        yield from (str(word) for word in process.argv if word.startswith("/"))
        if "mkdir" in process.line or "install -d" in process.line:
            yield from (word.strip("'\";&") for word in process.line.split() if word.startswith("/"))
