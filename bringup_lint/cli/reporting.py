"""What the command line adds to a report: the baseline's file, the terminal, the way the program was called."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator

from bringup_lint.cli.streams import say
from bringup_lint.cli.terminal import terminal_width
from bringup_lint.config import ConfigError
from bringup_lint.dataclass import replace
from bringup_lint.finding import Severity
from bringup_lint.plural import counted
from bringup_lint.type_names import TYPE_CHECKING

_BASELINE_LIMIT = 64 * 1024 * 1024
"""Bytes."""

if TYPE_CHECKING:
    from pathlib import Path

    from bringup_lint.baseline import Entry
    from bringup_lint.config import Config
    from bringup_lint.engine import Outcome
    from bringup_lint.report import Report
    from bringup_lint.robot import Robot


def report_of(
    outcome: Outcome, robot: Robot, config: Config, started: float, *, drawn: bool = False, told: bool = False
) -> Report:
    """The report of a run, for this terminal. Raises ConfigError when the baseline cannot be read."""
    from bringup_lint.finish import Invocation
    from bringup_lint.finish import finish

    report = finish(
        outcome,
        robot,
        Invocation(("bringup-lint", *sys.argv[1:]), os.getcwd(), started),
        fail_on=Severity[config.fail_on.upper()],
        baseline=baseline_of(config),
        drawn=drawn,
        told=told,
    )
    return replace(report, width=terminal_width(), narrowed=tuple(_narrowed(outcome, robot, config)))


def _narrowed(outcome: Outcome, robot: Robot, config: Config) -> Iterator[str]:
    """What a configuration that was found in the tree keeps from being judged, or judged as a part of the robot."""
    found = config.found
    if found is None:
        return
    if excluded := len(robot.tree.excluded):
        yield f"{counted(excluded, 'path')} excluded by {_name(found)}"
    if found.select and config.select == found.select:
        yield f"{counted(len(outcome.unsaid), 'rule')} not selected by {_name(found)}"
    if others := sum(purpose != "robot" for purpose in found.purpose.values()):
        yield f"purpose of {counted(others, 'path')} set by {_name(found)}"


def _name(config: Config) -> str:
    return os.path.basename(config.path) if config.path else ""


def known_to(config: Config) -> frozenset[str]:
    """The fingerprints in the baseline that the configuration names. Raises ConfigError."""
    return frozenset(entry.fingerprint for entry in baseline_of(config))


def baseline_of(config: Config) -> tuple[Entry, ...]:
    """The entries of the baseline that the configuration names. Raises ConfigError."""
    if not config.baseline:
        return ()
    from bringup_lint.baseline import BaselineError
    from bringup_lint.baseline import read
    from bringup_lint.discover.reading import Unreadable
    from bringup_lint.discover.reading import read_bytes

    path = config.beside(config.baseline)
    try:
        data, _ = read_bytes(path, _BASELINE_LIMIT, follow=True)
        return read(data.decode("utf-8"))
    except UnicodeDecodeError as error:
        raise ConfigError(f"{path}: not a baseline: not UTF-8") from error
    except (BaselineError, Unreadable) as error:
        raise ConfigError(f"{path}: {error}") from error


def save_baseline(report: Report, path: Path) -> Report:
    """Write the findings of a report, known ones too, to a baseline file. Returns the report in which all are known.
    Raises NotWritten."""
    from bringup_lint.baseline import entries_of
    from bringup_lint.baseline import written
    from bringup_lint.cli.reports import write

    entries = list(entries_of((*report.findings, *report.known), report.root, report.cwd))
    write(written(entries), path)
    say(f"{path} now holds {counted(len(entries), 'finding')}: --baseline {path} reports what is new")
    suppressed = tuple(found for found in report.findings if found.suppression is not None)
    code = report.exit_code if report.exit_code > 1 else 0
    return replace(report, findings=suppressed, known=(*report.known, *report.shown), stale=(), exit_code=code)


def prune_baseline(report: Report, config: Config) -> Report:
    """Take the findings that are gone out of the baseline of the configuration. Raises ConfigError, NotWritten."""
    from bringup_lint.baseline import written
    from bringup_lint.cli.reports import write

    entries, gone = baseline_of(config), frozenset(report.stale)
    path = os.path.relpath(config.beside(str(config.baseline)))
    left = [entry for entry in entries if entry.fingerprint not in gone]
    removed = [entry for entry in entries if entry.fingerprint in gone]
    if removed:
        from pathlib import Path

        write(written(left), Path(path))
    say(f"{path}: {counted(len(removed), 'finding')} removed, {len(left)} left")
    for entry in removed:
        say(f"  {entry.path}: {entry.rule}")
    return replace(report, stale=())
