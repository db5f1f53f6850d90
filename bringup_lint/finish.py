"""From the outcome of a run to the report that the formats render: mask, mark, leave out what is known."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterable
from collections.abc import Iterator
from typing import NamedTuple

from bringup_lint.baseline import sift
from bringup_lint.engine import Outcome
from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding.presented import presented
from bringup_lint.registry import Rule
from bringup_lint.report import Notification
from bringup_lint.report import Report
from bringup_lint.report import RuleDoc
from bringup_lint.report import Target
from bringup_lint.robot import Robot

DOCS = "https://bringup-lint.github.io/bringup-lint/rules/{}/"
"""Where a built-in rule is documented on the web: its page of the site."""


class Invocation(NamedTuple):
    """How the program was called."""

    command: tuple[str, ...]
    """The command line, program first."""
    cwd: str
    started: float
    """Seconds since the epoch."""


def finish(
    outcome: Outcome,
    robot: Robot,
    invocation: Invocation,
    *,
    fail_on: Severity = Severity.WARNING,
    baseline: frozenset[str] = frozenset(),
    drawn: bool = False,
) -> Report:
    """Everything that a format may say about a run.

    ``baseline`` holds the fingerprints of known findings, which go to ``Report.known``; ``drawn`` asks for the picture.
    """
    cwd, target = invocation.cwd, robot.target
    root = str(robot.tree.root or cwd)
    findings, mask = presented(outcome.findings, root, cwd)
    sifted = sift(findings, baseline)
    failures = [mask.words(failure) if mask else failure for failure in outcome.failures]
    picture = None
    if drawn:
        from bringup_lint.report.picture.document import picture as draw

        picture = draw(robot.graph, sifted.new, mask)
    return Report(
        findings=sifted.new,
        rules={rule_id: doc_of(rule) for rule_id, rule in outcome.rules.items()},
        kinds=Counter(source.kind for source in robot.sources if source.judged),
        root=root,
        cwd=cwd,
        target=Target(target.ros, target.systemd, target.ros_why, target.systemd_why),
        command=invocation.command,
        started=invocation.started,
        ended=time.time(),
        exit_code=exit_code(sifted.new, outcome.failures, fail_on),
        notifications=(*(Notification("error", failure) for failure in failures), *_not_read(robot)),
        below=outcome.hidden,
        elsewhere=outcome.elsewhere,
        known=sifted.known,
        picture=picture,
    )


def _not_read(robot: Robot) -> Iterator[Notification]:
    """What this user may not read of the running system; another one may."""
    closed = robot.tree.closed
    if closed:
        what = f"{closed[0]} and {len(closed) - 1} more" if len(closed) > 1 else closed[0]
        yield Notification("note", f"Not checked, because this user may not read it: {what}. Run it with sudo.")


def exit_code(findings: Iterable[Finding], failures: Iterable[str], fail_on: Severity) -> int:
    """3 when something failed inside, 1 for a finding as severe as ``fail_on`` that nothing suppresses, else 0."""
    if any(failures):
        return 3
    return int(any(finding.severity >= fail_on and not finding.suppression for finding in findings))


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
        DOCS.format(rule.id) if rule.builtin else "",
    )
