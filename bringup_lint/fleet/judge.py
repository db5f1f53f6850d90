"""The rules of the fleet, run over the summaries."""

from __future__ import annotations

from collections.abc import Iterable

from bringup_lint.config import Config
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import replace
from bringup_lint.finding import Severity
from bringup_lint.fleet.fleet import Fleet
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.members import Accepted
from bringup_lint.fleet.silence import Silence
from bringup_lint.isolation import failure
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.selection import Selection
from bringup_lint.selection import is_name_of
from bringup_lint.selection import source_of
from bringup_lint.suppress import UNUSED
from bringup_lint.suppress.files import file_ignores

FAMILY = "fleet"


@dataclass(frozen=True)
class Verdict:
    """What the rules of the fleet found."""

    findings: tuple[FleetFinding, ...]
    """The most severe first; accepted ones are among them."""
    rules: dict[str, Rule]
    failures: tuple[str, ...]
    hidden: int
    """How many findings lie below the lowest severity shown."""


def judge(
    fleet: Fleet, registry: Registry, config: Config, accepted: Iterable[Accepted] = (), *, ignores: bool = True
) -> Verdict:
    """``ignores``: whether anything silences findings. Raises ConfigError for names that mean nothing."""
    selection = Selection(registry, config)
    silence = _silence(accepted if ignores else (), config if ignores else Config(), selection)
    ids = [rule_id for rule_id in registry.family_of if rule_id.startswith(f"{FAMILY}/") and selection.runs(rule_id)]
    rules = {rule_id: registry[rule_id] for rule_id in ids}
    failures: dict[str, str] = {}
    findings: list[FleetFinding] = []
    for rule in rules.values():
        try:
            findings += (silence.apply(_graded(each, rule, selection)) for each in rule.check(fleet))
        except Exception as error:
            failures[rule.id] = failure(f"rule {rule.id}", error)
    if selection.runs(UNUSED):
        rules[UNUSED] = registry[UNUSED]
        said = silence.complaints(
            [robot.name for robot in fleet.robots],
            lambda name: selection.covers(name) and any(is_name_of(name, each) for each in set(ids) - set(failures)),
        )
        findings += (_graded(each, rules[UNUSED], selection) for each in said)
    lowest = Severity[config.min_severity.upper()]
    shown = [each for each in findings if each.severity >= lowest or each.rule in selection.select]
    return Verdict(tuple(sorted(shown, key=_order)), rules, tuple(failures.values()), len(findings) - len(shown))


def _silence(accepted: Iterable[Accepted], config: Config, selection: Selection) -> Silence:
    """Raises ConfigError for names that mean nothing."""

    def means(name: str, rule_id: str) -> bool:
        return is_name_of(selection.id_of(name), rule_id)

    known = tuple(replace(each, rule=selection.id_of(each.rule)) for each in accepted)
    files = file_ignores(config.per_file_ignores, source_of(config), means)
    return Silence(known, files)


def _graded(found: FleetFinding, rule: Rule, selection: Selection) -> FleetFinding:
    severity = selection.severity(rule.id) or found.own_severity or rule.severity
    confidence = min(found.own_confidence or rule.meta.confidence, rule.meta.confidence)
    return replace(found, rule=rule.id, severity=severity, confidence=confidence)


def _order(found: FleetFinding) -> tuple[int, str, str, str, int]:
    place = found.places[0]
    return (-found.severity, found.rule, place.robot, place.path, place.line)
