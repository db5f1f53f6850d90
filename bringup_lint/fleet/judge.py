"""The rules of the fleet, run over the summaries."""

from __future__ import annotations

import traceback
from collections.abc import Iterable
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import replace

from bringup_lint.config import Config
from bringup_lint.engine import Selection
from bringup_lint.finding import Severity
from bringup_lint.fleet.fleet import Fleet
from bringup_lint.fleet.fleet import FleetFinding
from bringup_lint.fleet.members import Accepted
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule

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


def judge(fleet: Fleet, registry: Registry, config: Config, accepted: Iterable[Accepted] = ()) -> Verdict:
    """Raises ConfigError for names that mean nothing."""
    selection = Selection(registry, config)
    accepted = tuple(accepted)
    for declared in accepted:
        selection.known(declared.rule)
    ids = [rule_id for rule_id in registry.paths if rule_id.startswith(f"{FAMILY}/") and selection.runs(rule_id)]
    rules = {rule_id: registry[rule_id] for rule_id in ids}
    lowest = Severity[config.min_severity.upper()]
    shown: list[FleetFinding] = []
    failures: list[str] = []
    hidden = 0
    for rule in rules.values():
        try:
            found = [_graded(each, rule, selection) for each in rule.check(fleet)]
        except Exception as error:
            failures.append(_failure(rule, error))
            continue
        for each in found:
            if each.severity >= lowest or each.rule in selection.select:
                shown += _declared(each, accepted)
            else:
                hidden += 1
    return Verdict(tuple(sorted(shown, key=_order)), rules, tuple(failures), hidden)


def _failure(rule: Rule, error: Exception) -> str:
    frame = traceback.extract_tb(error.__traceback__)[-1]
    return f"rule {rule.id} failed: {type(error).__name__} in {frame.filename.rpartition('/')[2]}:{frame.lineno}"


def _graded(found: FleetFinding, rule: Rule, selection: Selection) -> FleetFinding:
    severity = selection.severity(rule.id) or found.own_severity or rule.severity
    confidence = min(found.own_confidence or rule.meta.confidence, rule.meta.confidence)
    return replace(found, rule=rule.id, severity=severity, confidence=confidence)


def _declared(found: FleetFinding, accepted: Iterable[Accepted]) -> Iterator[FleetFinding]:
    """The finding, with the reason for which the inventory accepts it."""
    for each in accepted:
        about = found.difference.key if found.difference else ""
        odd = found.difference.odd_robots if found.difference else found.robots
        if each.rule == found.rule and about.startswith(each.key) and set(odd) <= set(each.robots or odd):
            yield replace(found, declared=each.reason)
            return
    yield found


def _order(found: FleetFinding) -> tuple[int, str, str, str, int]:
    place = found.places[0]
    return (-found.severity, found.rule, place.robot, place.path, place.line)
