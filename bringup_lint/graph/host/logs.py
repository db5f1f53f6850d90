"""Where ROS and the services write their logs, and what removes them again."""

from __future__ import annotations

import fnmatch
import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.shell import commands
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.host.fstab import Mounts
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.model.logrotate import Directive
    from bringup_lint.model.logrotate import LogrotateFile
    from bringup_lint.model.logrotate import Script
    from bringup_lint.model.logrotate import Stanza
    from bringup_lint.model.shell import Command
    from bringup_lint.source import Located
    from bringup_lint.source import Source

_DEFAULT = regex(r"(?:^|/)\.ros/log(?:/|$)")
_USUAL = regex(r"^/(?:var|opt|data|home)/(?:[^/]+/)*ros2?(?:/|$)")
_FILE = regex(r"append:(/[^%]+)")
_CLEANS = regex(
    r"-delete\b|-mtime\b|-mmin\b|\btmpreaper\b|\btmpwatch\b|\brm\s+-|\bvacuum\b|\bshutil\.rmtree\b|\bunlink\b"
)
_AGE = regex(r"^[deDvQqRrxX]\S*[ \t]+(?P<path>\S+)(?:[ \t]+\S+){3}[ \t]+(?P<age>[^\s-]\S*)", re.M)
_MADE = regex(
    r"^[dDvqQ]\S*[ \t]+(?P<path>/\S+)[ \t]+(?P<mode>[~:]?[0-7]{3,4})[ \t]+(?P<user>[\w-]+)[ \t]+(?P<group>[\w-]+)",
    re.M,
)


class LogPath(NamedTuple):
    """A folder or file that grows, and who says so."""

    path: str
    where: Located
    unit: Unit
    folder: bool


class RosLogs:
    """The log folders of the robot's units, and the logrotate stanzas."""

    def __init__(self, sources: Files, units: Callable[[], Units], mounts: Callable[[], Mounts]) -> None:
        self.sources = sources
        self.units = units
        self.mounts = mounts

    @cached_property
    def files(self) -> list[LogrotateFile]:
        """The judged logrotate files."""
        sources = [source for source in self.sources.of_kind("logrotate") if source.judged and not source.template]
        if not sources:
            return []
        from bringup_lint.parsers.logrotate import parse

        return self.sources.parsed(parse, sources)

    @cached_property
    def stanzas(self) -> list[Stanza]:
        return [stanza for file in self.files for stanza in file.stanzas]

    @property
    def directives(self) -> list[str]:
        """The words that logrotate knows."""
        from bringup_lint.parsers.logrotate import directives

        return list(directives())

    @staticmethod
    def owners(directive: Directive) -> tuple[Located | None, Located | None]:
        """The user and the group that ``create``, ``createolddir`` or ``su`` names."""
        from bringup_lint.parsers.logrotate import directives
        from bringup_lint.parsers.logrotate_values import owners

        kind = directives()[directive.name].type
        user, group, _ = owners(kind, directive.value) if kind in ("owner", "su") else (None, None, False)
        return user, group

    @staticmethod
    def commands(script: Script) -> list[Command]:
        """The shell commands of a script of a stanza."""
        return commands(script.body)

    @property
    def by_folder(self) -> dict[str, list[LogrotateFile]]:
        """The files that logrotate reads together, in its order."""
        found: dict[str, list[LogrotateFile]] = {}
        for file in sorted(self.files, key=lambda file: file.source.name):
            found.setdefault(file.source.name.rpartition("/")[0], []).append(file)
        return found

    @cached_property
    def written(self) -> list[LogPath]:
        """ROS_LOG_DIR and the ``append:`` files of the judged services, each path once."""
        found: dict[str, LogPath] = {}
        units = self.units()
        for unit in units.services:
            variable = units.environment(unit).get("ROS_LOG_DIR")
            if variable is not None and variable.text is not None and variable.text.startswith("/"):
                path = variable.text.rstrip("/")
                found.setdefault(path, LogPath(path, variable.value, unit, True))
            for key in ("StandardOutput", "StandardError"):
                value = unit.get(key)
                if value is None or unit.is_opaque(value):
                    continue
                match = _FILE.fullmatch(value)
                if match:
                    found.setdefault(match[1], LogPath(match[1], value, unit, False))
        return list(found.values())

    def is_of_ros(self, stanza: Stanza) -> bool:
        """Whether a stanza rotates what ROS nodes write."""
        return any(self.source_of(path) is not None for path in stanza.paths)

    def source_of(self, path: str) -> Located | str | None:
        """Why a path holds ROS logs: the ROS_LOG_DIR that says so, or words; None when nothing does."""
        for log in self.written:
            if log.folder and (path.startswith(f"{log.path}/") or path == log.path):
                return log.where
        if _DEFAULT.search(path) or _USUAL.search(path):
            return "ROS writes here by default" if _DEFAULT.search(path) else "a log folder of ROS"
        return None

    def uncovered(self) -> Iterator[LogPath]:
        """What units write and nothing in the tree rotates, ages or deletes."""
        for log in self.written:
            if not self._is_covered(log):
                yield log

    def _is_covered(self, log: LogPath) -> bool:
        for stanza in self.stanzas:
            if any(_matches(path, log) for path in stanza.paths):
                return True
        return any(self._mentions(source.text, log.path) for source in self._cleaners)

    @cached_property
    def _cleaners(self) -> list[Source]:
        """Sources that may clean up: tmpfiles, cron jobs, scripts and units."""
        kinds = ("tmpfiles", "cron", "shell-script", "systemd-unit", "systemd-dropin", "logrotate")
        return [source for source in self.sources.of_kind(*kinds) if source.matches(_CLEANS) or source.matches(_AGE)]

    @staticmethod
    def _mentions(text: str, path: str) -> bool:
        parents = [each for each in (path, path.rpartition("/")[0]) if each.count("/") > 1]
        return any(re.search(rf"{re.escape(each)}(?:/?[\s*\"']|/?$)", text, re.M) for each in parents)

    def aged(self, path: str) -> bool:
        """Whether a tmpfiles.d line with an age covers the folder of a stanza's path."""
        return any(
            path.startswith(match["path"].rstrip("/*") or "/")
            for source in self.sources.of_kind("tmpfiles")
            for match in _AGE.finditer(source.text)
        )

    def open_folder(self, folder: str) -> tuple[Located, str, str] | None:
        """Who makes a folder that group or others may write to: the place, a word on it, and ``USER GROUP`` to rotate
        as."""
        for source in self.sources.of_kind("tmpfiles"):
            for match in _MADE.finditer(source.text):
                if match["path"].rstrip("/") == folder:
                    mode, group = int(match["mode"].lstrip("~:"), 8), match["group"]
                    loose = mode & 0o002 or (mode & 0o020 and group not in ("root", "0", "-"))
                    where = source.located(*match.span("mode"))
                    return (where, f"created with mode {match['mode']}", f"{match['user']} {group}") if loose else None
        fstab = self.mounts().only
        if fstab is None:
            return None
        for mount in fstab.mounts:
            if mount.is_tmpfs and mount.target == folder and mount.option("mode") is None:
                return mount.target, "a tmpfs without mode= has mode 1777", ""
        return None


def _matches(pattern: str, log: LogPath) -> bool:
    if log.folder:
        return pattern.startswith(f"{log.path}/")
    return fnmatch.fnmatchcase(log.path, pattern) and pattern.count("/") == log.path.count("/")
