"""The run: choose rules, run them, suppress, sort. The engine names no rule but the ones that speak of itself."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping

from bringup_lint import budget
from bringup_lint.config import Config
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import replace
from bringup_lint.finding import Applicability
from bringup_lint.finding import Confidence
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Severity
from bringup_lint.finding import Suppression
from bringup_lint.finding import changed
from bringup_lint.finding.copies import merged
from bringup_lint.isolation import check
from bringup_lint.isolation import too_slow
from bringup_lint.isolation import unread
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.robot import OF_SYNTAX
from bringup_lint.robot import Robot
from bringup_lint.selection import Selection
from bringup_lint.selection import means
from bringup_lint.selection import should_have_silenced
from bringup_lint.selection import source_of
from bringup_lint.source import Source
from bringup_lint.steps import Steps
from bringup_lint.steps import failing
from bringup_lint.suppress import UNUSED
from bringup_lint.suppress import Ignores
from bringup_lint.suppress import ignores_in
from bringup_lint.suppress.files import file_ignores


@dataclass(frozen=True)
class Outcome:
    """What a run found."""

    findings: tuple[Finding, ...]
    """Sorted by place; suppressed ones carry their suppression."""
    rules: dict[str, Rule]
    """The rules that ran, by id."""
    failures: tuple[str, ...]
    """What failed inside, one line each."""
    hidden: dict[Severity, int]
    """How many findings of each severity lie below the lowest severity shown."""
    unsaid: frozenset[str] = frozenset()
    """The rules that were not asked for."""
    quiet: frozenset[tuple[str, str]] = frozenset()
    """Rules and files of the findings below the lowest severity shown."""
    elsewhere: int = 0
    """How many findings are left out because the change that is judged has no part in them."""


SUPPRESSING, COMMENTS = "suppressing", "reading the comments"


def run(
    robot: Robot,
    registry: Registry,
    config: Config,
    *,
    ignores: bool = True,
    between: Callable[[], None] = lambda: None,
) -> Outcome:
    """Run the selected rules over a robot. Raises ConfigError for names that mean nothing, RuleError for a bad rule,
    and what ``between`` raises, which is called between the rules to end a run that nobody waits for."""
    selection = Selection(registry, config)
    asked = registry.ids_for(robot)
    rules = {rule_id: registry[rule_id] for rule_id in asked if selection.runs(rule_id)}
    muted = {rule_id: registry[rule_id] for rule_id in asked if selection.mutes(rule_id)}
    if not ignores:
        rules, muted = {**rules, **muted}, {}
    checked = check(_in_order(rules.values(), robot), robot, registry.purposes, between)
    failures = [*checked.failures, *unread(robot)]
    steps = Steps()
    judged = steps.each(checked.findings, "asking what reads its file", lambda found: _by_use(found, robot, registry))
    findings = [*judged, *failures]
    robot.let_go_of_uncalled()
    findings += [too_slow(source, "Not judged: to parse it", budget.FILE) for source in robot.unfinished]
    if ignores:
        findings = _suppressed(findings, robot, rules, selection, config, steps)
    if muted:
        findings += _muted(check(muted.values(), robot, registry.purposes, between).findings, selection, config)
        rules.update(muted)
    graded = steps.each(findings, "grading", lambda found: _graded(found, rules.get(found.rule), selection))
    unique = list(_unique(sorted(graded, key=_order)))
    folded = steps.attempt("looking for copies", lambda: list(merged(unique)), unique)
    shown, hidden = _parted([*folded, *steps.unplaced], Severity[config.min_severity.upper()], selection)
    unsaid = frozenset(registry.family_of.keys() - selection.running)
    said = dict.fromkeys(failure.message for failure in (*failures, *steps.failures))
    quiet = frozenset((found.rule, found.source.name) for found in hidden)
    return Outcome(tuple(shown), rules, tuple(said), Counter(found.severity for found in hidden), unsaid, quiet)


def _parted(findings: Iterable[Finding], lowest: Severity, selection: Selection) -> tuple[list[Finding], list[Finding]]:
    """The findings that are shown, and those below the lowest severity, of rules that nobody asked for by name."""
    shown: list[Finding] = []
    hidden: list[Finding] = []
    for found in findings:
        (shown if found.severity >= lowest or found.rule in selection.select else hidden).append(found)
    return shown, hidden


def _in_order(rules: Iterable[Rule], robot: Robot) -> Iterator[Rule]:
    """The rules that may ask for the syntax of nodes, then the others, for which it need not be kept."""
    others: list[Rule] = []
    for rule in rules:
        if rule.asks is None or rule.asks & OF_SYNTAX:
            yield rule
        else:
            others.append(rule)
    robot.let_go_of_syntax()
    yield from others


def _muted(findings: Iterable[Finding], selection: Selection, config: Config) -> Iterator[Finding]:
    """What rules found that a configuration switches off: it is counted, so that nobody silences it unseen."""
    source = source_of(config)
    for found in findings:
        if selection.mutes(found.rule):
            name = selection.muted_by(found.rule)
            start = max(config.text.find(name), 0)
            where, reason = source.span(start, start + len(name)), f"'{name}' is switched off in {source.basename}"
            yield changed(found, suppression=Suppression(where, reason, external=True))


def _by_use(found: Finding, robot: Robot, registry: Registry) -> Finding:
    """The finding, lowered where its place is what tests read, which is often wrong on purpose and on no robot, and
    where nothing of the robot's own leads to its file."""
    lowered = registry.in_test_data(found.rule)
    if lowered is not None and robot.files.is_test_data(found.span):
        found = changed(found, own_severity=min(found.own_severity or lowered, lowered))
    lowered = registry.unreached(found.rule)
    if lowered is None or _severity(found, registry) <= lowered or robot.leads_to(found.span):
        return found
    return changed(found, own_severity=lowered)


def _severity(found: Finding, registry: Registry) -> Severity:
    return found.own_severity or registry[found.rule].severity


def _suppressed(
    findings: Iterable[Finding],
    robot: Robot,
    rules: Mapping[str, Rule],
    selection: Selection,
    config: Config,
    steps: Steps,
) -> list[Finding]:
    """The findings with what comments and configuration say of them, and what there is to say of these."""

    def is_name_of(name: str, rule_id: str) -> bool:
        return means(name, rules.get(rule_id), rule_id)

    def ran(name: str) -> bool:
        return should_have_silenced(name, rules, selection)

    findings = list(findings)
    comments = _comments(_with_modules(robot.sources, findings), is_name_of, steps)
    files = file_ignores(config.per_file_ignores, source_of(config), is_name_of)

    def silenced(found: Finding) -> Finding:
        return files.apply(comments.apply(found))

    applied = list(steps.each(findings, SUPPRESSING, silenced))
    complaints: list[Finding] = steps.attempt(COMMENTS, lambda: list(comments.complaints(ran)), [])
    applied += steps.each((found for found in complaints if found.rule in rules), SUPPRESSING, silenced)
    if config.per_file_ignores and UNUSED in rules:
        applied += steps.attempt(COMMENTS, lambda: list(files.complaints(robot.tree.paths, robot.sources, ran)), [])
    return applied


def _with_modules(sources: list[Source], findings: Iterable[Finding]) -> list[Source]:
    """The sources, and those that were only read for another one, such as a module that a node imports, in which
    something was found."""
    known = {id(source) for source in sources}
    return [*sources, *{id(each.source): each.source for each in findings if id(each.source) not in known}.values()]


def _comments(sources: list[Source], is_name_of: Callable[[str, str], bool], steps: Steps) -> Ignores:
    """The suppression comments of the sources of which they can be read."""
    try:
        return ignores_in(sources, is_name_of)
    except Exception:
        broken = {id(source): error for source, error in failing(sources, lambda part: ignores_in(part, is_name_of))}
        for source in sources:
            if id(source) in broken:
                steps.note_failure(Source(source.name), f"{COMMENTS} in {source.name}", broken[id(source)])
        return ignores_in([source for source in sources if id(source) not in broken], is_name_of)


def _graded(found: Finding, rule: Rule | None, selection: Selection) -> Finding:
    own = rule.severity if rule else Severity.ERROR
    highest = rule.meta.confidence if rule else Confidence.HIGH
    return changed(
        found,
        severity=selection.severity(found.rule) or found.own_severity or own,
        confidence=min(found.own_confidence or highest, highest),
        fix=_as_safe_as(rule, found.fix),
    )


def _as_safe_as(rule: Rule | None, fix: Fix | None) -> Fix | None:
    """The fix, unsafe unless the rule says that its fixes are safe, and where it changes more places than it names."""
    from bringup_lint.parsers.repeated_values import changes_repeated_values

    if fix is None or rule is None or (rule.meta.fix == "safe" and not changes_repeated_values(fix)):
        return fix
    return replace(fix, applicability=Applicability.UNSAFE)


def _order(found: Finding) -> tuple[str, int, int, str, str]:
    return (found.span.path, found.span.start, found.span.end, found.rule, found.message)


def _unique(findings: Iterable[Finding]) -> Iterator[Finding]:
    seen = set()
    for found in findings:
        key = _order(found)
        if key not in seen:
            seen.add(key)
            yield found
