"""What fails inside costs as little as it can: a finding, else a source, else a rule.

Parsers are isolated where they are called (``Files.parsed``). What fails later, in a layer of the graph or in a rule,
is blamed on the source that was looked at: the innermost call that holds a source of the tree tells which. The rules
that failed run again on a robot of which this source is unknown, so that they speak of all other sources.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from types import TracebackType

from bringup_lint import budget
from bringup_lint.budget import OutOfTime
from bringup_lint.budget import handled
from bringup_lint.budget import limited
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.discover import disk
from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.finding import changed
from bringup_lint.finding.origin import at_origin
from bringup_lint.graph.purpose import Purpose
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.registry import Rule
from bringup_lint.robot import Robot
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

INTERNAL_ERROR = "lint/internal-error"
TIME_BUDGET = "lint/time-budget"
_ROUNDS = 12
"""How many times rules run again without the sources that were blamed."""
_PACKAGE = "/bringup_lint/"

Purposes = Callable[[str], Mapping[Purpose, "Severity | None"]]
"""Rule id -> what a purpose makes of its findings."""


class _Failure(NamedTuple):
    rule: Rule
    error: Exception


@dataclass
class Checked:
    """What rules found, and what failed inside."""

    findings: list[Finding] = field(default_factory=list)
    failures: list[Finding] = field(default_factory=list)


def check(
    rules: Iterable[Rule], robot: Robot, purposes: Purposes, between: Callable[[], None] = lambda: None
) -> Checked:
    """Run rules over a robot. Raises what ``between`` raises, which is called before each rule."""
    checked = Checked()
    with handled():
        failed = _attempt(_with_pauses(rules, between), robot, purposes, checked.findings)
    unknown: dict[str, Source] = {}
    names = {source.name for source in robot.sources}
    is_of_tree = robot.tree.is_file
    for _ in range(_ROUNDS):
        blamed = list(_blamed(failed, unknown, lambda name: name in names or is_of_tree(name)))
        if not blamed:
            break
        for failure, source in blamed:
            unknown[source.name] = source
            checked.failures.append(internal(source, _step(failure), failure.error))
        robot = robot.without(unknown)
        found: list[Finding] = []
        failed = _attempt(dict.fromkeys(each.rule for each in failed), robot, purposes, found)
        checked.findings += (each for each in found if not _concerns(each, unknown))
        checked.failures += unread(robot)
    for failure in failed:
        checked.failures.append(internal(Source(failure.rule.file), f"rule {failure.rule.id}", failure.error))
    return checked


def _with_pauses(rules: Iterable[Rule], between: Callable[[], None]) -> Iterator[Rule]:
    for rule in rules:
        between()
        yield rule


def unread(robot: Robot) -> Iterator[Finding]:
    """The sources on which a parser failed."""
    for source, error in robot.failures:
        yield internal(source, f"reading {source.name}", error)


def failure(what: str, error: Exception) -> str:
    """What failed inside, in words that say where, and nothing that a file holds."""
    import traceback

    frames = traceback.extract_tb(error.__traceback__)
    where = f" in {frames[-1].filename.rpartition('/')[2]}:{frames[-1].lineno}" if frames else ""
    return f"{what} failed: {type(error).__name__}{where}"


def internal(source: Source, what: str, error: Exception) -> Finding:
    """A finding for what failed inside."""
    return Finding(
        failure(what, error),
        source.whole,
        rule=INTERNAL_ERROR,
        severity=Severity.ERROR,
        advice="this is a bug in bringup-lint; everything else was still checked",
    )


def _attempt(rules: Iterable[Rule], robot: Robot, purposes: Purposes, findings: list[Finding]) -> list[_Failure]:
    """Run rules, each on its own, and gather what they find; returns what failed."""
    failed: list[_Failure] = []
    end = time.process_time() + budget.RUN
    for rule in rules:
        left = end - time.process_time()
        own = purposes(rule.id)
        if left <= 0:
            findings.append(too_slow(Source(rule.file), f"Not run: the rules before {rule.id}", budget.RUN))
            continue
        try:
            with limited(min(left, budget.RULE)):
                for found in rule.check(robot) or ():
                    _gather(rule, found, robot, own, findings, failed)
        except OutOfTime:
            findings.append(
                too_slow(Source(rule.file), f"Not judged whole: the rule {rule.id}", min(left, budget.RULE))
            )
        except Exception as error:
            failed.append(_Failure(rule, error))
    return failed


def too_slow(source: Source, what: str, seconds: float) -> Finding:
    """A finding for what was stopped because it took too long, which it may not do another time."""
    disk.depends_on_more()
    return Finding(
        f"{what} takes more than {seconds:.0f} seconds of CPU time",
        source.whole,
        rule=TIME_BUDGET,
        advice="exclude what is generated or damaged; for an ordinary tree this is a bug in bringup-lint",
    )


def _gather(
    rule: Rule,
    found: Finding,
    robot: Robot,
    purposes: Mapping[Purpose, Severity | None],
    findings: list[Finding],
    failed: list[_Failure],
) -> None:
    try:
        _validate(found)
        if found.source.judged:
            findings += _for_purpose(at_origin(changed(found, rule=rule.id)), robot, purposes)
    except Exception as error:
        failed.append(_Failure(rule, error))


def _validate(found: Finding) -> None:
    """Raises TypeError for a place that is none: whatever follows relies on them."""
    places = [found.span, *found.hidden, *found.secrets]
    places += (each.span for each in (*found.related, *found.chain))
    if found.fix:
        places += (edit.span for edit in found.fix.edits)
    for span in places:
        if not isinstance(span, Span) or not isinstance(span.source, Source):
            raise TypeError("a finding without its place")
    if not isinstance(found.message, str):
        raise TypeError("a finding without words")


def _for_purpose(found: Finding, robot: Robot, purposes: Mapping[Purpose, Severity | None]) -> Iterator[Finding]:
    """The finding, lowered or left out when its place is not for the robot itself."""
    purpose = robot.purpose(found.span) if purposes else Purpose.ROBOT
    if purpose not in purposes:
        yield found
        return
    lowered = purposes[purpose]
    if lowered is not None:
        yield changed(found, own_severity=min(found.own_severity or lowered, lowered))


def _blamed(
    failed: Iterable[_Failure], unknown: Collection[str], is_of_tree: Callable[[str], bool]
) -> Iterator[tuple[_Failure, Source]]:
    """For each source that failures are blamed on, the first of them."""
    seen = set(unknown)
    for failure in failed:
        source = next((each for each in _looked_at(failure.error) if each.name and is_of_tree(each.name)), None)
        if source is not None and source.name not in seen:
            seen.add(source.name)
            yield failure, source


def _looked_at(error: Exception) -> Iterator[Source]:
    """The sources that the calls which failed were about, the innermost first."""
    frames: list[TracebackType] = []
    step = error.__traceback__
    while step is not None:
        frames.append(step)
        step = step.tb_next
    for frame in reversed(frames):
        if frame.tb_frame.f_globals is globals():
            continue
        for value in list(frame.tb_frame.f_locals.values()):
            source = _source_of(value)
            if source is not None:
                yield source if source.origin is None else source.origin.whole.source


def _source_of(value: object) -> Source | None:
    """The source that a value is, or that it says it comes from."""
    if isinstance(value, Source):
        return value
    if isinstance(value, Located):
        return value.span.source
    try:
        own = getattr(value, "source", None)
    except Exception:
        return None
    return own if isinstance(own, Source) else None


def _step(failure: _Failure) -> str:
    """Where it failed: the rule, or the module of a layer."""
    import traceback

    file = traceback.extract_tb(failure.error.__traceback__)[-1].filename
    if file == str(failure.rule.path) or _PACKAGE not in file:
        return f"rule {failure.rule.id}"
    return file.rpartition(_PACKAGE)[2].removesuffix(".py").replace("/", ".")


def _concerns(found: Finding, unknown: Mapping[str, Source]) -> bool:
    """Whether a finding speaks of a source of which nothing is known: that it says something not may be wrong."""
    spans = (found.span, *(each.span for each in (*found.related, *found.chain)))
    words = f"{found.message}\n{found.advice}\n" + "\n".join(span.text for span in spans)
    return any(span.path in unknown for span in spans) or any(each.basename in words for each in unknown.values())
