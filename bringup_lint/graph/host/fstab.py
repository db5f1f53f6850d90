"""Mounts joined to the units that need what lies on them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.facts import table
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.model.fstab import Fstab
from bringup_lint.model.fstab import Mount
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.fstab import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.systemd.units import Units

_FILE = regex(r"(?:file|append|truncate):(/.+)")
_MAKES = regex(r"\b(?:mkdir|install\s+(?:-\w+\s+)*-d|systemd-tmpfiles)\b")
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


@dataclass(frozen=True, eq=False)
class Mounts:
    """The mounts of the robot, and the units that need what lies on them."""

    files: Files
    units: Callable[[], Units]

    @cached_property
    def fstabs(self) -> list[Fstab]:
        return self.files.parsed(parse, [source for source in self.files.of_kind("fstab") if not source.template])

    @property
    def only(self) -> Fstab | None:
        """The fstab of the robot, when the tree has exactly one."""
        return self.fstabs[0] if len(self.fstabs) == 1 else None

    @property
    def missing_directories(self) -> Iterator[NeededPath]:
        """Directories on a tmpfs that units need and that nothing creates at boot."""
        fstab = self.only
        if fstab is None or not any(mount.is_tmpfs for mount in fstab.mounts):
            return
        for unit in self._units_of(fstab):
            seen: set[str] = set()
            for path, where in [*_written(unit, self.units()), *_bound(unit)]:
                mount = fstab.mount_of(path)
                if mount is None or not mount.is_tmpfs or path in seen or path == str(mount.target).rstrip("/"):
                    continue
                seen.add(path)
                if not _is_created(unit, path, self.files, self.units()):
                    yield NeededPath(mount, path, where, unit)

    @property
    def read_only_writes(self) -> Iterator[NeededPath]:
        """Paths that units write to and that lie on a read-only root."""
        fstab = self.only
        if fstab is None:
            return
        for unit in self._units_of(fstab):
            for path, where in _written(unit, self.units()):
                mount = fstab.mount_of(path)
                if mount is not None and mount.target == "/" and mount.is_read_only and not path.startswith(_RUNTIME):
                    yield NeededPath(mount, path, where, unit)

    def _units_of(self, fstab: Fstab) -> Iterator[Unit]:
        """The units of the same robot."""
        return (unit for unit in self.units().judged if self.files.same_robot(unit.where.source, fstab.source))


def _written(unit: Unit, units: Units) -> Iterator[tuple[str, Located]]:
    """The directories that a unit certainly writes to."""
    if unit.type != "service":
        return
    log = units.environment(unit).get("ROS_LOG_DIR")
    if log is not None and log.text is not None and log.text.startswith("/"):
        yield log.text.rstrip("/"), log.value
    for key in ("StandardOutput", "StandardError"):
        value = unit.get(key)
        if value is None:
            continue
        match = _FILE.fullmatch(value)
        if match and "%" not in match[1]:
            yield posixpath.dirname(match[1]), value


def _bound(unit: Unit) -> Iterator[tuple[str, Located]]:
    """The paths that must exist for the unit's name space."""
    for word in unit.words("ReadWritePaths", unit.section):
        if word.startswith("/") and "%" not in word:
            yield word.rstrip("/"), word


def _is_created(unit: Unit, path: str, files: Files, units: Units) -> bool:
    """Whether something creates a directory at boot, as far as the tree shows."""
    for other in units.judged:
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
    if any(line.search(source.text) for source in files.sources if "tmpfiles.d/" in source.name):
        return True
    made = re.compile(rf"\b(?:mkdir|install)\b[^\n]*{re.escape(path)}\b")
    return any(made.search(source.text) for source in files.of_kind("shell-script"))
