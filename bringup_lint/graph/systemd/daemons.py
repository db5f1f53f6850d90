"""journald.conf, system.conf and logind.conf with their drop-ins, merged as systemd reads them.

Per journald.conf(5) and its likes: one main file (that of /etc hides the vendor's), then the drop-ins of all
directories in the order of their names, where a file of the same name in a higher directory hides the others. The
last valid value of a key wins.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from typing import TypeVar

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.files import Files
from bringup_lint.model.schema import Item
from bringup_lint.model.unit import Assignment
from bringup_lint.model.unit import Section
from bringup_lint.model.unit import UnitFile
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers import daemon_conf
from bringup_lint.parsers.systemd_values import ValueProblem
from bringup_lint.parsers.systemd_values import parse_bool
from bringup_lint.parsers.unit import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

Value = TypeVar("Value")

DIRECTORIES = ("/etc/systemd", "/run/systemd", "/usr/local/lib/systemd", "/usr/lib/systemd", "/lib/systemd")
"""In the order in which they win."""
_COMMENTED = regex(r"^[ \t]*[#;][ \t]*(\w+)[ \t]*=[ \t]*((?:.*[^ \t\n])?)[ \t]*$", re.M)


class DaemonLine(NamedTuple):
    """An assignment in the section of the daemon."""

    file: UnitFile
    assignment: Assignment
    setting: Item | None
    """None when the daemon has no such key."""


@dataclass(eq=False)
class Daemon:
    """The configuration of one daemon of one robot."""

    name: str
    """``journald``, ``system`` or ``logind``."""
    root: str
    """What is before the path on the robot; tells overlays and variants apart."""
    files: list[UnitFile] = field(default_factory=list)
    """In the order in which they apply, without those that a higher directory hides."""
    certain: bool = True
    """False when two main files lie side by side, so that nothing tells which one counts."""

    @property
    def section(self) -> str:
        return daemon_conf.section_of(self.name).name

    @property
    def judged(self) -> list[UnitFile]:
        return [file for file in self.files if file.source.judged]

    @cached_property
    def lines(self) -> list[DaemonLine]:
        """Every line of the daemon's section."""
        known = daemon_conf.settings(self.name)
        return [
            DaemonLine(file, assignment, known.get(assignment.key))
            for file in self.files
            for assignment in file.assignments
            if assignment.section == self.section and assignment.key
        ]

    def get(self, *keys: str, read: Callable[[str], Value | None]) -> tuple[Located, Value] | None:
        """The last value of one of the keys (spellings of one setting) that ``read`` accepts; an empty one resets."""
        found = None
        for line in self.lines:
            if line.assignment.key not in keys or line.assignment.opaque:
                continue
            value = read(line.assignment.value)
            if value is not None:
                found = (line.assignment.value, value)
            elif not line.assignment.value:
                found = None
        return found

    def flag(self, key: str) -> tuple[Located, bool] | None:
        """The last boolean of a key."""
        return self.get(key, read=parse_bool)

    def sets(self, *keys: str) -> bool:
        """Whether some line says something of one of the keys, or may once a template is filled in."""
        return any(line.assignment.key in keys for line in self.lines) or any(file.uncertain for file in self.files)

    @property
    def where(self) -> Source | Located:
        """What a finding about something that is not set points at: the section's last header, else the file."""
        headers = [section.name for file in self.judged for section in file.sections if section.name == self.section]
        return headers[-1] if headers else self.judged[-1].source

    def commented(self) -> Iterator[tuple[UnitFile, Located, Located, Located]]:
        """Comment lines of judged files that hold an assignment: the file, the line, the key and the value."""
        known = daemon_conf.settings(self.name)
        for file in self.judged:
            for match in _COMMENTED.finditer(file.source.text):
                if match[1] in known:
                    line, key, value = (file.source.located(*match.span(group)) for group in (0, 1, 2))
                    yield file, line, key, value


def load_daemons(files: Files, name: str) -> list[Daemon]:
    """One Daemon for each root or folder that holds files of it."""
    groups: dict[str, list[tuple[int, bool, UnitFile]]] = {}
    for file in files.parsed(parse, files.of_kind(f"{name}-conf")):
        root, rank, main = _place(file.source, name)
        groups.setdefault(root, []).append((rank, main, file))
    return [_merged(name, root, group) for root, group in groups.items()]


def _place(source: Source, name: str) -> tuple[str, int, bool]:
    """The root of a file, the rank of its directory, and whether it is the main file."""
    path = source.robot_path or ""
    display = f"/{source.name}"
    folder = display.rpartition("/")[0]
    main = not folder.endswith(f"{name}.conf.d")
    directory = path.rpartition("/")[0].removesuffix(f"/{name}.conf.d")
    if directory in DIRECTORIES:
        return display.removesuffix(path), DIRECTORIES.index(directory), main
    return folder.removesuffix(f"/{name}.conf.d"), 0, main


def _merged(name: str, root: str, group: list[tuple[int, bool, UnitFile]]) -> Daemon:
    mains = sorted(((rank, file) for rank, main, file in group if main), key=lambda each: each[0])
    highest = [file for rank, file in mains if rank == mains[0][0]]
    dropins: dict[str, tuple[int, UnitFile]] = {}
    for rank, main, file in group:
        known = dropins.get(file.source.basename)
        if not main and (known is None or rank < known[0]):
            dropins[file.source.basename] = (rank, file)
    ordered = [dropins[basename][1] for basename in sorted(dropins)]
    return Daemon(name, root, [*highest, *ordered], certain=len(highest) <= 1)


def value_problems(line: DaemonLine, version: int) -> Iterator[ValueProblem]:
    """What the daemon finds wrong with the value of a known key."""
    value = line.assignment.value
    if line.setting is not None and value and not line.assignment.opaque:
        yield from daemon_conf.value_problems(line.setting, value, version)


def setting_names(name: str) -> list[str]:
    """The keys that a daemon knows."""
    return list(daemon_conf.settings(name))


def unknown_keys(daemon: Daemon) -> Iterator[Assignment]:
    """Lines of judged files with a key that no release of the daemon knows."""
    for line in daemon.lines:
        if line.setting is None and _ours(line.file) and not line.assignment.key.startswith("X-"):
            yield line.assignment


def newer_keys(daemon: Daemon, version: int) -> Iterator[tuple[Assignment, int]]:
    """Lines of judged files whose key this release does not know yet, with the release that does."""
    for line in daemon.lines:
        if line.setting is not None and daemon_conf.since(line.setting) > version and _ours(line.file):
            yield line.assignment, daemon_conf.since(line.setting)


def bad_values(daemon: Daemon, version: int) -> Iterator[tuple[Assignment, ValueProblem]]:
    """Values of judged files that the daemon cannot read, so that it ignores the line."""
    for line in daemon.lines:
        if line.setting is not None and _ours(line.file):
            for problem in value_problems(line, version):
                if problem.code in ("invalid", "out-of-range", "not-absolute", "not-normalized"):
                    yield line.assignment, problem


def other_sections(daemon: Daemon) -> Iterator[Section]:
    """Sections of judged files that the daemon ignores."""
    for file in daemon.judged:
        for section in file.sections:
            if section.name != daemon.section and not section.name.startswith("X-") and _ours(file):
                yield section


def headless(daemon: Daemon) -> Iterator[tuple[Located, int]]:
    """For each judged file with lines before any section header: the first of them, and how many there are."""
    known = daemon_conf.settings(daemon.name)
    for file in daemon.judged:
        places = [problem.where for problem in file.problems if problem.code == "line-outside-section"]
        lines = [where for where in places if isinstance(where, Located)]
        if any(line.partition("=")[0].strip() in known for line in lines) and not file.source.template:
            yield lines[0], len(lines)


def _ours(file: UnitFile) -> bool:
    return file.source.judged and not file.source.template
