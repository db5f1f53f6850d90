"""The command lines of a service: the Exec settings, with what they really run.

systemd.service(5), "Command lines"; systemd replaces ``$$`` and known variables before the program sees them.
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.commands.command_line import CommandLine
from bringup_lint.graph.commands.following import follow
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.parsers.systemd_values import split_command_line
from bringup_lint.source import Located
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

EXEC_KEYS = (
    "ExecCondition",
    "ExecStartPre",
    "ExecStart",
    "ExecStartPost",
    "ExecReload",
    "ExecStop",
    "ExecStopPost",
)


@dataclass(eq=False, kw_only=True)
class Process(CommandLine):
    """One command line of a unit."""

    unit: Unit
    key: str
    prefixes: str


def processes(unit: Unit, files: Files) -> list[Process]:
    """The command lines of a service, in the order of ``EXEC_KEYS``, with what their shells and scripts run."""
    return [
        process
        for key in EXEC_KEYS
        for value in unit.values(key, "Service")
        for process in _of(unit, key, value, files)
    ]


def _of(unit: Unit, key: str, value: Located, files: Files) -> Iterator[Process]:
    for line in split_command_line(value).commands:
        if line.argv:
            process = Process(value, tuple(line.argv), unit=unit, key=key, prefixes=line.prefixes)
            follow(process, lambda path: files.find(path, path.span.source) if path.startswith("/") else None)
            yield process
