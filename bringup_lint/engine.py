"""The run: choose rules, run them, suppress, sort. The engine names no rule but the ones that speak of itself."""

from __future__ import annotations

import traceback
from collections.abc import Iterable
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from dataclasses import replace

from bringup_lint.config import Config
from bringup_lint.config import ConfigError
from bringup_lint.finding import Confidence
from bringup_lint.finding import Finding
from bringup_lint.finding import Severity
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.robot import Robot
from bringup_lint.source import Source
from bringup_lint.spelling import meant
from bringup_lint.suppress import ignores_in

INTERNAL_ERROR = "lint/internal-error"


@dataclass(eq=False)
class Outcome:
    """What a run found."""

    findings: list[Finding] = field(default_factory=list)
    """Sorted by place; suppressed ones carry their suppression."""
    rules: dict[str, Rule] = field(default_factory=dict)
    """The rules that ran, by id."""
    failures: list[str] = field(default_factory=list)
    """What failed inside, one line each."""
    hidden: dict[Severity, int] = field(default_factory=dict)
    """How many findings of each severity lie below the lowest severity shown."""

    def exit_code(self, fail_on: Severity) -> int:
        if self.failures:
            return 3
        return int(any(item.severity >= fail_on and not item.suppression for item in self.findings))


class Selection:
    """Which rules run: ``select`` minus ``ignore``, each a rule id, a family, or an older name of a rule."""

    def __init__(self, registry: Registry, select: Iterable[str], ignore: Iterable[str]):
        self.registry = registry
        self.families = {family.name for family in registry.families}
        self.select = [self.known(name) for name in select if name != "all"]
        self.ignore = [self.known(name) for name in ignore]

    def known(self, name: str) -> str:
        """The id that a name means. Raises ConfigError when it means none."""
        if name in self.families or name in self.registry.paths:
            return name
        for rule in self.registry.all():
            if name in rule.meta.aliases:
                return rule.id
        near = meant(name, [*self.families, *self.registry.paths])
        raise ConfigError(f"no rule or family is called '{name}'" + (f"; did you mean '{near}'?" if near else ""))

    def runs(self, rule_id: str) -> bool:
        if any(names(name, rule_id) for name in self.ignore):
            return False
        return not self.select or any(names(name, rule_id) for name in self.select)


def names(name: str, rule_id: str) -> bool:
    """Whether a name of a rule or family means the rule."""
    return name == rule_id or rule_id.startswith(name + "/")


def run(robot: Robot, registry: Registry, config: Config, *, ignores: bool = True) -> Outcome:
    """Run the selected rules over a robot. Raises ConfigError for names that mean nothing, RuleError for a bad rule."""
    selection = Selection(registry, config.select, config.ignore)
    severities = {selection.known(name): Severity[value.upper()] for name, value in config.severity.items()}
    outcome = Outcome()
    findings: list[Finding] = []
    for rule_id in registry.ids_for(robot):
        if selection.runs(rule_id):
            outcome.rules[rule_id] = registry.get(rule_id)
            findings += _run_rule(outcome.rules[rule_id], robot, outcome)
    for source, error in robot.failures:
        findings.append(_internal(outcome, source, f"reading {source.name}", error))
    if ignores:
        comments = ignores_in(robot.sources, lambda name, rule_id: _means(name, outcome.rules.get(rule_id), rule_id))
        findings = [comments.apply(found) for found in findings]
        findings += [
            found
            for found in comments.complaints(lambda name: _counts(name, outcome, selection))
            if found.rule in outcome.rules
        ]
    lowest = Severity[config.min_severity.upper()]
    for found in _unique(sorted((_graded(found, outcome, severities) for found in findings), key=_order)):
        if found.severity >= lowest or found.rule in selection.select:
            outcome.findings.append(found)
        else:
            outcome.hidden[found.severity] = outcome.hidden.get(found.severity, 0) + 1
    return outcome


def _run_rule(rule: Rule, robot: Robot, outcome: Outcome) -> Iterator[Finding]:
    try:
        for found in rule.check(robot) or ():
            if found.source.judged:
                yield replace(found, rule=rule.id)
    except Exception as error:
        yield _internal(outcome, Source(rule.path.name), f"rule {rule.id}", error)


def _internal(outcome: Outcome, source: Source, what: str, error: Exception) -> Finding:
    frame = traceback.extract_tb(error.__traceback__)[-1]
    message = f"{what} failed: {type(error).__name__} in {frame.filename.rpartition('/')[2]}:{frame.lineno}"
    outcome.failures.append(message)
    return Finding(
        message,
        source.whole,
        rule=INTERNAL_ERROR,
        advice="this is a bug in bringup-lint; everything else was still checked",
    )


def _graded(found: Finding, outcome: Outcome, severities: dict[str, Severity]) -> Finding:
    rule = outcome.rules.get(found.rule)
    own = rule.severity if rule else Severity.ERROR
    highest = rule.meta.confidence if rule else Confidence.HIGH
    return replace(
        found,
        severity=severities.get(found.rule) or found.own_severity or own,
        confidence=min(found.own_confidence or highest, highest),
    )


def _means(name: str, rule: Rule | None, rule_id: str) -> bool:
    return names(name, rule_id) or (rule is not None and name in rule.meta.aliases)


def _counts(name: str, outcome: Outcome, selection: Selection) -> bool:
    """Whether it is wrong that an ignored name silenced nothing: its rules ran, or it names no rule at all."""
    if any(_means(name, rule, rule_id) for rule_id, rule in outcome.rules.items()):
        return True
    try:
        selection.known(name)
    except ConfigError:
        return True
    return False


def _order(found: Finding) -> tuple[str, int, int, str, str]:
    return (found.span.path, found.span.start, found.span.end, found.rule, found.message)


def _unique(findings: Iterable[Finding]) -> Iterator[Finding]:
    seen = set()
    for found in findings:
        key = _order(found)
        if key not in seen:
            seen.add(key)
            yield found
