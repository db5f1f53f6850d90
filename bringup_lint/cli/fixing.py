"""``--fix`` and ``--diff``: rounds of fixes, what they have done, and what they would do."""

from __future__ import annotations

import difflib
from collections import Counter
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING
from typing import Any

import click

from bringup_lint.fix import TOUCHES
from bringup_lint.fix import Changes
from bringup_lint.fix import Plan
from bringup_lint.fix import apply_fixes
from bringup_lint.fix import planned
from bringup_lint.fix import taken_back

if TYPE_CHECKING:
    from bringup_lint.engine import Outcome
    from bringup_lint.finding import Finding
    from bringup_lint.robot import Robot

Checked = Callable[[], "tuple[Robot, Outcome]"]
ROUNDS = 20
"""Fixes that touch each other are applied one after the other; no more than so often."""


def fix_files(robot: Robot, outcome: Outcome, checked: Checked, *, unsafe: bool) -> tuple[Robot, Outcome, list[str]]:
    """Apply fixes until there is nothing to do. After each round there must be less to fix for each rule that was
    fixed, and no text may come back; else the round is taken back, and these rules are left alone. Returns what is
    there afterwards, and why files were not written."""
    unwritten: list[str] = []
    fixed: Counter[str] = Counter()
    stubborn: set[str] = set()
    seen: set[tuple[str, str]] = set()
    for _ in range(ROUNDS):
        before = _to_do(outcome, unsafe)
        done = apply_fixes((found for found in outcome.findings if found.rule not in stubborn), unsafe=unsafe)
        unwritten = [str(failure) for failure in done.failures]
        if not done.findings:
            break
        robot, outcome = checked()
        seen |= {(change.source.name, change.source.text) for change in done.written}
        returned = any((change.source.name, change.new_text()) in seen for change in done.written)
        again = _not_less({finding.rule for finding in done.findings}, before, _to_do(outcome, unsafe), returned)
        if again:
            stubborn |= again
            unwritten += map(str, taken_back(done.written))
            robot, outcome = checked()
        else:
            fixed.update(finding.rule for finding in done.findings)
    _tell(fixed, planned(outcome.findings, unsafe=unsafe), stubborn)
    return robot, outcome, unwritten


def _not_less(rules: set[str], before: Counter[str], after: Counter[str], returned: bool) -> set[str]:
    """The rules of which as much is left to fix as before a round."""
    return rules if returned else {rule for rule in rules if after[rule] >= before[rule]}


def _to_do(outcome: Outcome, unsafe: bool) -> Counter[str]:
    """How many findings of each rule can be fixed, together or one after the other."""
    plan = planned(outcome.findings, unsafe=unsafe)
    found = [finding for finding, _ in plan.taken] + [finding for finding, why in plan.left if why == TOUCHES]
    return Counter(finding.rule for finding in found)


def _tell(fixed: Counter[str], plan: Plan, stubborn: Iterable[str] = ()) -> None:
    """Say on stderr what was fixed, by rule, and what was not and why."""
    count = fixed.total()
    if count:
        click.echo(f"Fixed {count} finding{'s' * (count > 1)}.", err=True)
    for rule, times in sorted(fixed.items()):
        click.echo(f"  {times} {rule}", err=True)
    for rule in sorted(stubborn):
        click.echo(f"Not fixed: {rule} (as much would be left to fix afterwards)", err=True)
    left = Counter((why, finding.rule) for finding, why in plan.left)
    for (why, rule), times in sorted(left.items()):
        click.echo(f"Not fixed: {times} {rule} ({why})", err=True)


def show_diff(outcome: Outcome, *, unsafe: bool) -> int:
    """Print what the fixes would change, without secrets; 1 when that is something, 3 when something failed inside."""
    plan = planned(outcome.findings, unsafe=unsafe)
    for name in sorted(plan.changes):
        click.echo("".join(_diff(name, plan.changes[name], outcome.findings)), nl=False)
    if outcome.failures:
        return 3
    return int(bool(plan.changes))


def _diff(name: str, change: Changes, findings: Iterable[Finding]) -> Iterator[str]:
    from bringup_lint.finding.redact import mask_of

    old, new = change.source, replace(change.source, text=change.new_text())
    mask = mask_of((found for found in findings if found.source is old), (old, new))
    if mask:
        old, new = mask.source(old), mask.source(new)
    lines = difflib.unified_diff(_lines(old.text), _lines(new.text), fromfile=name, tofile=name)
    for line in lines:
        yield line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n"


def _lines(text: str) -> list[str]:
    """The lines as diff counts them: with their ends, and split at line feeds alone."""
    return [part + "\n" for part in text.split("\n")[:-1]] + list(filter(None, [text.rpartition("\n")[2]]))


def print_fixed(robot: Robot, outcome: Outcome, checked: Checked, options: dict[str, Any], *, unsafe: bool) -> int:
    """Fix standard input and print it; 1 when findings are left."""
    fixed: Counter[str] = Counter()
    seen: set[bytes] = set()
    source = robot.sources[0]
    for _ in range(ROUNDS):
        plan = planned(outcome.findings, unsafe=unsafe)
        change = plan.changes.get(source.name)
        if change is None:
            break
        to_do = _to_do(outcome, unsafe)
        seen.add(options["stdin_data"])
        before, options["stdin_data"] = options["stdin_data"], change.new_text().encode()
        robot, outcome = checked()
        rules = {finding.rule for finding, _ in plan.taken}
        if _not_less(rules, to_do, _to_do(outcome, unsafe), options["stdin_data"] in seen):
            options["stdin_data"] = before
            robot, outcome = checked()
            break
        source = robot.sources[0]
        fixed.update(finding.rule for finding, _ in plan.taken)
    click.echo(source.text, nl=False)
    _tell(fixed, planned(outcome.findings, unsafe=unsafe))
    return 3 if outcome.failures else int(any(not found.suppression for found in outcome.findings))
