"""Mounts joined to the units that need what lies on them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.facts import table
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.model.fstab import Fstab
from bringup_lint.model.fstab import Mount
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

_FILE = re.compile(r"(?:file|append|truncate):(/.+)")
_MAKES = re.compile(r"\b(?:mkdir|install\s+(?:-\w+\s+)*-d|systemd-tmpfiles)\b")
_RUNTIME = ("/run", "/dev", "/proc", "/sys")


class NeededPath(NamedTuple):
    """A path that a unit needs, and the mount that it lies on."""

    mount: Mount
    path: str
    where: Located
    unit: Unit


def mount_options(filesystem: str) -> list[str]:
    """The options of a file system with those that hold for every one; empty when it is not in the table."""
    rows = {row["filesystem"]: row["options"].split() for row in table("host/mount_options")}
    return [*rows["*"], *rows[filesystem]] if filesystem in rows and filesystem != "*" else []


def only_fstab(robot: Robot) -> Fstab | None:
    """The fstab of the robot, when the tree has exactly one."""
    return robot.fstabs[0] if len(robot.fstabs) == 1 else None


def lost_directories(robot: Robot) -> Iterator[NeededPath]:
    """Directories on a tmpfs that units need and that nothing makes at boot."""
    fstab = only_fstab(robot)
    if fstab is None or not any(mount.is_tmpfs for mount in fstab.mounts):
        return
    for unit in _units(robot, fstab):
        seen = set()
        for path, where in [*_written(robot, unit), *_bound(unit)]:
            mount = fstab.mount_of(path)
            if mount is None or not mount.is_tmpfs or path in seen or path == mount.target.rstrip("/"):
                continue
            seen.add(path)
            if not _is_made(robot, unit, path):
                yield NeededPath(mount, path, where, unit)


def read_only_writes(robot: Robot) -> Iterator[NeededPath]:
    """Paths that units write to and that lie on a read-only root."""
    fstab = only_fstab(robot)
    for unit in _units(robot, fstab) if fstab is not None else ():
        for path, where in _written(robot, unit):
            mount = fstab.mount_of(path)
            if mount is not None and mount.target == "/" and mount.is_read_only and not path.startswith(_RUNTIME):
                yield NeededPath(mount, path, where, unit)


def _units(robot: Robot, fstab: Fstab) -> Iterator[Unit]:
    """The units of the same robot."""
    return (unit for unit in robot.units.judged if robot.same_robot(unit.where.source, fstab.source))


def _written(robot: Robot, unit: Unit) -> Iterator[tuple[str, Located]]:
    """The directories that a unit certainly writes to."""
    if unit.type != "service":
        return
    log = robot.units.environment(unit).get("ROS_LOG_DIR")
    if log is not None and log.text is not None and log.text.startswith("/"):
        yield log.text.rstrip("/"), log.value
    for key in ("StandardOutput", "StandardError"):
        value = unit.get(key)
        match = _FILE.fullmatch(value) if value is not None else None
        if match and "%" not in match[1]:
            yield posixpath.dirname(match[1]), value


def _bound(unit: Unit) -> Iterator[tuple[str, Located]]:
    """The paths that must exist for the unit's name space."""
    for word in unit.words("ReadWritePaths", unit.section):
        if word.startswith("/") and "%" not in word:
            yield word.rstrip("/"), word


def _is_made(robot: Robot, unit: Unit, path: str) -> bool:
    """Whether something makes a directory at boot, as far as the tree shows."""
    for other in robot.units.judged:
        for key, base in (
            ("LogsDirectory", "/var/log"),
            ("RuntimeDirectory", "/run"),
            ("CacheDirectory", "/var/cache"),
        ):
            if any(path == f"{base}/{word.partition(':')[0]}" for word in other.words(key, other.section)):
                return True
    for key in ("ExecStartPre", "ExecStart", "ExecCondition"):
        if any(path in value and _MAKES.search(value) for value in unit.values(key, unit.section)):
            return True
    line = re.compile(rf"^[dDvqQeC][!+-]*\s+\S*{re.escape(path)}(?:/|\s|$)|^[dD]\S*\s+{re.escape(path)}\b", re.M)
    if any(line.search(source.text) for source in robot.sources if "tmpfiles.d/" in source.name):
        return True
    made = re.compile(rf"\b(?:mkdir|install)\b[^\n]*{re.escape(path)}\b")
    return any(made.search(source.text) for source in robot.of_kind("shell-script"))
