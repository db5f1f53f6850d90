"""From the outcome of a run to the report that the formats render."""

from __future__ import annotations

import os
import sys
import time
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

from bringup_lint.config import ConfigError
from bringup_lint.finding import Severity
from bringup_lint.report import Notification
from bringup_lint.report import Report
from bringup_lint.report import RuleDoc
from bringup_lint.report import Target

if TYPE_CHECKING:
    from bringup_lint.config import Config
    from bringup_lint.engine import Outcome
    from bringup_lint.registry import Rule
    from bringup_lint.robot import Robot

DOCS = "https://github.com/bringup-lint/bringup-lint/blob/main/rules/{}.py"
"""Where a built-in rule is documented on the web: its file, which begins with its documentation."""


def save_baseline(outcome: Outcome, robot: Robot, path: Path) -> None:
    """Write the findings of a run to a baseline file."""
    from bringup_lint.baseline import written
    from bringup_lint.cli.outputs import write

    write(written(outcome.findings, root_of(robot), os.getcwd()), path)
    count = sum(found.suppression is None for found in outcome.findings)
    findings = f"{count} finding{'s' * (count != 1)}"
    print(f"{path} holds {findings} now: --baseline {path} reports what is new", file=sys.stderr)


def take_known(outcome: Outcome, robot: Robot, config: Config) -> int:
    """Take the findings that the baseline holds out of the outcome; returns how many. Raises ConfigError."""
    if not config.baseline:
        return 0
    from bringup_lint.baseline import BaselineError
    from bringup_lint.baseline import read
    from bringup_lint.baseline import sift

    path = config.folder / config.baseline
    try:
        sifted = sift(outcome.findings, read(path.read_text("utf-8")), root_of(robot), os.getcwd())
    except OSError as error:
        raise ConfigError(f"{path}: {error.strerror}") from error
    except BaselineError as error:
        raise ConfigError(f"{path}: {error}") from error
    outcome.findings = list(sifted.new)
    return len(sifted.known)


def root_of(robot: Robot) -> str:
    """What the URIs of a report are relative to."""
    return str(robot.tree.root or os.getcwd())


def report_of(outcome: Outcome, robot: Robot, config: Config, started: float, known: int = 0) -> Report:
    """Everything that a format may say about a run."""
    target = robot.target
    return Report(
        findings=tuple(outcome.findings),
        rules={rule_id: doc_of(rule) for rule_id, rule in outcome.rules.items()},
        kinds=Counter(source.kind for source in robot.sources if source.judged),
        root=root_of(robot),
        cwd=os.getcwd(),
        target=Target(target.ros, target.systemd, target.ros_why, target.systemd_why),
        command=("bringup-lint", *sys.argv[1:]),
        started=started,
        ended=time.time(),
        exit_code=outcome.exit_code(Severity[config.fail_on.upper()]),
        notifications=tuple(Notification("error", failure) for failure in outcome.failures),
        below=outcome.hidden,
        known=known,
        width=terminal_width(),
    )


def doc_of(rule: Rule) -> RuleDoc:
    """A rule's documentation."""
    meta = rule.meta
    return RuleDoc(
        rule.id,
        rule.doc,
        meta.severity,
        meta.confidence,
        meta.fix,
        meta.since,
        meta.symptoms,
        meta.tags,
        meta.aliases,
        DOCS.format(rule.id.replace("-", "_")) if rule.builtin else "",
    )


def terminal_width() -> int:
    """Columns to set text in: COLUMNS, else the terminal's, at most 100; 80 where there is no terminal."""
    given = os.environ.get("COLUMNS", "")
    if given.isdigit() and int(given):
        return min(int(given), 100)
    try:
        return min(os.get_terminal_size(sys.__stdout__.fileno()).columns or 80, 100)
    except (OSError, ValueError, AttributeError):
        return 80


def wants_colour(forced: bool | None) -> bool:
    """Whether standard output gets colour: the option, else FORCE_COLOR, NO_COLOR, and whether it is a terminal."""
    if forced is not None:
        return forced
    if os.environ.get("NO_COLOR"):
        return False
    return bool(os.environ.get("FORCE_COLOR")) or (sys.stdout.isatty() and os.environ.get("TERM") != "dumb")
