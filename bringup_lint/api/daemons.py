"""journald.conf, system.conf and logind.conf: their effective settings, and the rules that they share."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api.schema import unknown_name
from bringup_lint.api.schema import wrong_value
from bringup_lint.finding import Finding
from bringup_lint.graph.systemd.daemons import Daemon
from bringup_lint.graph.systemd.daemons import bad_values
from bringup_lint.graph.systemd.daemons import headless
from bringup_lint.graph.systemd.daemons import newer_keys
from bringup_lint.graph.systemd.daemons import other_sections
from bringup_lint.graph.systemd.daemons import setting_names
from bringup_lint.graph.systemd.daemons import unknown_keys as keys_unknown_to
from bringup_lint.graph.target import Target
from bringup_lint.on_demand import on_demand
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.parsers.daemon_conf import watchdog_seconds
else:
    __getattr__ = on_demand(globals())

__all__ = ["Daemon", "invalid_values", "lines_without_section", "unknown_keys", "unknown_sections", "watchdog_seconds"]

PROGRAMS = {"journald": "journald", "system": "systemd", "logind": "logind"}
MANUALS = {"journald": "journald.conf(5)", "system": "systemd-system.conf(5)", "logind": "logind.conf(5)"}


def invalid_values(configurations: Iterable[Daemon], target: Target) -> Iterator[Finding]:
    """A value that does not follow the grammar of its key."""
    for daemon in configurations:
        for assignment, problem in bad_values(daemon, target.newest):
            text, program = problem.suggestion, PROGRAMS[daemon.name]
            message = f"{assignment.key}= takes {problem.expected}, not '{problem.where}': {program} ignores the line"
            yield wrong_value(problem.where, message, text, f"write {problem.expected}", safe=problem.safe)


def unknown_keys(configurations: Iterable[Daemon], target: Target) -> Iterator[Finding]:
    """A key that no release knows, or not yet the robot's."""
    for daemon in configurations:
        for assignment in keys_unknown_to(daemon):
            key = assignment.key
            meant = nearest(key, setting_names(daemon.name))
            message = f"Unknown key '{key}' in [{daemon.section}]: {PROGRAMS[daemon.name]} ignores the line"
            yield unknown_name(key, message, meant, f"remove the line, or see {MANUALS[daemon.name]}")
        if not target.systemd_known:
            continue
        for assignment, since in newer_keys(daemon, target.systemd):
            yield finding(
                assignment.key,
                f"{assignment.key}= needs systemd {since}; the robot has {target.systemd} ({target.systemd_why}), "
                "which ignores it",
                advice=f"remove the line, or update to systemd {since}",
                severity="warning",
            )


def unknown_sections(configurations: Iterable[Daemon]) -> Iterator[Finding]:
    """A section other than the daemon's own."""
    for daemon in configurations:
        known, own = setting_names(daemon.name), daemon.section
        for section in other_sections(daemon):
            keys = [assignment.key for assignment in section.assignments]
            change = fix(f"rename to [{own}]", (section.name, own))
            yield finding(
                section.name,
                f"{PROGRAMS[daemon.name]} reads [{own}] only: [{section.name}] is ignored",
                advice=f"rename it to [{own}]",
                fix=change if keys and all(key in known for key in keys) else None,
            )


def lines_without_section(configurations: Iterable[Daemon]) -> Iterator[Finding]:
    """Lines above the first section header."""
    for daemon in configurations:
        for first, count in headless(daemon):
            what = "this line is" if count == 1 else f"these {count} lines are"
            yield finding(
                first,
                f"There is no [{daemon.section}] above: {what} ignored",
                advice=f"add [{daemon.section}] above",
                fix=fix(f"insert [{daemon.section}]", (first.part(0, 0), f"[{daemon.section}]\n")),
            )
