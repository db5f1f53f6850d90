"""From the outcome of a run to the report that the formats render: mask, mark, leave out what is known."""

from __future__ import annotations

import contextlib
import os
import time
from collections import Counter
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from collections.abc import Sequence

from bringup_lint.baseline import Entry
from bringup_lint.baseline import path_of
from bringup_lint.baseline import sift
from bringup_lint.dataclass import replace
from bringup_lint.engine import Outcome
from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding.presented import Presented
from bringup_lint.finding.presented import presented
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.registry import Rule
from bringup_lint.registry import doc_of
from bringup_lint.report import Notification
from bringup_lint.report import Report
from bringup_lint.report import RuleDoc
from bringup_lint.report import Target
from bringup_lint.report import render
from bringup_lint.report.order import LONG
from bringup_lint.report.order import at_boot
from bringup_lint.robot import Robot
from bringup_lint.source import Source
from bringup_lint.steps import Steps
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import Any

if TYPE_CHECKING:
    from bringup_lint.finding.redact import Mask


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
    baseline: Iterable[Entry] = (),
    drawn: bool = False,
    told: bool = False,
) -> Report:
    """Everything that a format may say about a run.

    ``baseline`` holds the entries of known findings, which go to ``Report.known``; ``drawn`` asks for the
    picture, ``told`` for what a text for people needs.
    """
    cwd, target = invocation.cwd, robot.target
    root = robot.tree.root or cwd
    steps = Steps()
    findings, mask = _masked(outcome.findings, root, cwd, steps)
    sifted = sift(findings, baseline)
    picture = steps.attempt("drawing the picture", lambda: _drawn(robot, sifted.new, mask), None) if drawn else None
    nothing: frozenset[str] = frozenset()
    many = told and sum(found.suppression is None for found in sifted.new) > LONG
    boot = steps.attempt("ordering the findings", lambda: at_boot(robot.graph), nothing) if many else nothing
    failures = [mask.words(failure) if mask else failure for failure in outcome.failures]
    failures += (failure.message for failure in steps.failures)
    return Report(
        findings=(*sifted.new, *steps.unplaced),
        rules=_Docs(outcome.rules),
        kinds=Counter(source.kind for source in robot.sources if source.judged),
        root=root,
        cwd=cwd,
        target=Target(target.ros, target.systemd, target.ros_why, target.systemd_why),
        command=invocation.command,
        started=invocation.started,
        ended=time.time(),
        exit_code=exit_code(sifted.new, failures, fail_on),
        notifications=(*(Notification("error", failure) for failure in failures), *_not_read(robot)),
        below=outcome.hidden,
        elsewhere=outcome.elsewhere,
        known=sifted.known,
        stale=tuple(_stale(sifted.gone, outcome, robot, root, cwd)),
        picture=picture,
        at_boot=boot,
    )


def _stale(gone: Sequence[Entry], outcome: Outcome, robot: Robot, root: str, cwd: str) -> Iterator[str]:
    """The fingerprints of the entries whose finding is gone: this run would have found it, and it is none of those
    below the lowest severity shown."""
    if outcome.failures:
        return
    quiet = {(rule, path_of(name, root, cwd)) for rule, name in outcome.quiet} if gone else set()
    for entry in gone:
        if entry.rule in outcome.unsaid or (entry.rule, entry.path) in quiet:
            continue
        if robot.tree.judges(os.path.join(root, entry.path)):
            yield entry.fingerprint


class _Docs(Mapping[str, RuleDoc]):
    """The documentation of the rules that ran, of which most reports ask for none."""

    def __init__(self, rules: Mapping[str, Rule]) -> None:
        self.rules = rules

    def __getitem__(self, rule_id: str) -> RuleDoc:
        return doc_of(self.rules[rule_id])

    def __iter__(self) -> Iterator[str]:
        return iter(self.rules)

    def __len__(self) -> int:
        return len(self.rules)


def _masked(findings: tuple[Finding, ...], root: str, cwd: str, steps: Steps) -> Presented:
    """The findings without their secrets. Those that cannot be masked are not shown."""
    try:
        return presented(findings, root, cwd)
    except Exception:
        sound = steps.each_sound(findings, "masking", lambda part: presented(part, root, cwd))
        return steps.attempt("masking", lambda: presented(sound, root, cwd), Presented((), None))


def _drawn(robot: Robot, findings: tuple[Finding, ...], mask: Mask | None) -> dict[str, Any]:
    from bringup_lint.report.picture.document import picture

    return picture(robot.graph, findings, mask)


def rendered(output_format: str, report: Report) -> tuple[str, int]:
    """The report in a format, and the exit code. A finding that cannot be rendered is replaced, and a picture left
    out."""
    try:
        return render(output_format, report), report.exit_code
    except Exception as error:
        first = error
    what = f"rendering as {output_format}"
    plain = replace(report, picture=None, known=())
    render(output_format, replace(plain, findings=()))
    steps = Steps()
    sound = steps.each_sound(
        report.findings, what, lambda part: render(output_format, replace(plain, findings=tuple(part)))
    )
    if steps.failures:
        with contextlib.suppress(Exception):
            return render(output_format, _failed(report, sound, steps)), 3
    steps.note_failure(Source("bringup-lint"), what, first)
    return render(output_format, _failed(plain, (*sound, *steps.unplaced), steps)), 3


def _failed(report: Report, findings: tuple[Finding, ...], steps: Steps) -> Report:
    told = (Notification("error", failure.message) for failure in steps.failures)
    return replace(report, findings=findings, exit_code=3, notifications=(*report.notifications, *told))


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
