"""``--fix`` and ``--diff``: rounds of fixes, what they have done, and what they would do."""

from __future__ import annotations

import difflib
import os
import re
import sys
from collections import Counter
from collections.abc import Callable
from collections.abc import Iterable
from typing import TYPE_CHECKING

import click

from bringup_lint.cli.streams import plain
from bringup_lint.cli.streams import say
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.dataclass import replace
from bringup_lint.fix import TOUCHES
from bringup_lint.fix import Changes
from bringup_lint.fix import Fixed
from bringup_lint.fix import Plan
from bringup_lint.fix import Proposal
from bringup_lint.fix import apply_fixes
from bringup_lint.fix import planned
from bringup_lint.fix import taken_back
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.plural import counted

if TYPE_CHECKING:
    from bringup_lint.cli.run_options import RunOptions
    from bringup_lint.engine import Outcome
    from bringup_lint.finding import Finding
    from bringup_lint.robot import Robot
    from bringup_lint.source import Source
    from bringup_lint.writing import NotWritten

Checked = Callable[[], "tuple[Robot, Outcome]"]
CONTEXTS = (3, 2, 1)
"""Lines around a change, as many as hold no command of a CI runner."""
_COMMAND = regex(r"##(?:vso)?\[|(?:^[^\S\n]|\r)[^\S\r\n]*::", re.I | re.M)
"""What the runner of GitHub or the agent of Azure takes for a command in a line: the first anywhere, the second at the
start after blanks. A carriage return ends a line, too."""
LISTED = 8
"""Rules that are named one by one when their fixes are not applied."""
ROUNDS = 20
"""Fixes that touch each other are applied one after the other; no more than so often."""


class State(NamedTuple):
    """What is there, and what could be done to it."""

    robot: Robot
    outcome: Outcome
    plan: Plan

    def to_do(self) -> Counter[str]:
        """How many findings of each rule can be fixed, together or one after the other."""
        found = [finding for finding, _ in self.plan.taken]
        found += [finding for finding, why in self.plan.left if why == TOUCHES]
        return Counter(finding.rule for finding in found)


@dataclass
class Rounds:
    """Rounds of fixes, until there is nothing to do. After each one there must be less to fix for each rule that was
    fixed, and no text may come back; else the round is taken back, and these rules are left alone."""

    checked: Checked
    unsafe: bool
    apply: Callable[[Plan], Fixed] = apply_fixes
    take_back: Callable[[Iterable[Changes]], tuple[NotWritten, ...]] = taken_back
    fixed: Counter[str] = field(default_factory=Counter)
    stubborn: set[str] = field(default_factory=set)

    def run(self, robot: Robot, outcome: Outcome) -> tuple[State, list[str]]:
        """What is there afterwards, and why files were not written."""
        state = self.state_of(robot, outcome)
        unwritten: list[str] = []
        not_taken_back: list[str] = []
        seen: set[tuple[str, str]] = set()
        for _ in range(ROUNDS):
            done = self.apply(self._allowed(state))
            unwritten = [str(failure) for failure in done.failures]
            if not done.findings:
                break
            after = self.state_of(*self.checked())
            seen |= {(change.source.name, change.source.text) for change in done.written}
            returned = any((change.source.name, change.new_text()) in seen for change in done.written)
            again = _not_less({finding.rule for finding in done.findings}, state, after, returned)
            if not again:
                self.fixed.update(finding.rule for finding in done.findings)
                state = after
                continue
            self.stubborn |= again
            failures = self.take_back(done.written)
            if failures:
                not_taken_back += map(str, failures)
                state = self.state_of(*self.checked())
        return state, unwritten + not_taken_back

    def state_of(self, robot: Robot, outcome: Outcome) -> State:
        return State(robot, outcome, planned(outcome.findings, unsafe=self.unsafe))

    def _allowed(self, state: State) -> Plan:
        """What may be done: no fix of a rule that is left alone."""
        if not self.stubborn:
            return state.plan
        allowed = (each for each in state.outcome.findings if each.rule not in self.stubborn)
        return planned(allowed, unsafe=self.unsafe)


def fix_files(robot: Robot, outcome: Outcome, checked: Checked, *, unsafe: bool) -> tuple[Robot, Outcome, list[str]]:
    """Apply fixes and say what was done. Returns what is there afterwards, and why files were not written."""
    rounds = Rounds(checked, unsafe)
    state, unwritten = rounds.run(robot, outcome)
    _tell(rounds.fixed, state.plan, rounds.stubborn)
    return state.robot, state.outcome, unwritten


def _not_less(rules: set[str], before: State, after: State, returned: bool) -> set[str]:
    """The rules of which as much is left to fix as before a round."""
    if returned:
        return rules
    old, new = before.to_do(), after.to_do()
    return {rule for rule in rules if new[rule] >= old[rule]}


def _tell(fixed: Counter[str], plan: Plan, stubborn: Iterable[str] = (), done: str = "Fixed") -> None:
    """Say on stderr what was fixed, by rule, and what was not and why."""
    count = fixed.total()
    if count:
        say(f"{done} {counted(count, 'finding')}.")
    for rule, times in sorted(fixed.items()):
        say(f"  {times} {rule}")
    for rule in sorted(stubborn):
        say(f"Not fixed: {rule} (as much would be left to fix afterwards)")
    left: dict[str, Counter[str]] = {}
    for finding, why in plan.left:
        left.setdefault(why, Counter())[finding.rule] += 1
    for why, rules in sorted(left.items()):
        _tell_left(why, rules)


def _tell_left(why: str, rules: Counter[str]) -> None:
    """Say what was not fixed for one reason: by rule, or the number of rules when there are many."""
    if len(rules) > LISTED:
        say(f"Not fixed: {rules.total()} findings of {len(rules)} rules ({why})")
        return
    for rule, times in sorted(rules.items()):
        say(f"Not fixed: {times} {rule} ({why})")


def show_diff(robot: Robot, outcome: Outcome, checked: Checked, *, unsafe: bool) -> int:
    """Print what all rounds of fixes would change, without secrets; 1 when that is something, 3 when something failed
    inside."""
    from bringup_lint.discover.reading import proposed

    proposal = Proposal()

    def proposed_check() -> tuple[Robot, Outcome]:
        with proposed(proposal.texts):
            return checked()

    rounds = Rounds(proposed_check, unsafe, proposal.apply, proposal.take_back)
    state, _ = rounds.run(robot, outcome)
    last = state.outcome
    _tell(rounds.fixed, state.plan, rounds.stubborn, done="Would fix")
    diffs = [_quiet_diff(source, proposal, (*outcome.findings, *last.findings)) for source in _in_order(proposal)]
    text = "".join(diffs)
    click.echo(plain(text) if sys.stdout.isatty() else text, nl=False)
    if outcome.failures or last.failures:
        return 3
    return int(bool(text))


def _in_order(proposal: Proposal) -> list[Source]:
    return [proposal.before[name] for name in sorted(proposal.before)]


def _quiet_diff(old: Source, proposal: Proposal, findings: Iterable[Finding]) -> str:
    """The diff of a file. It is a patch, in which no line can be changed: where a CI runner would see a command in it,
    it has less context, and where the change itself holds one, it is left out."""
    before, after = _texts(old, proposal, findings)
    for context in CONTEXTS:
        diff = _diff(old.name, before, after, context)
        if not _COMMAND.search(diff):
            return diff
    say(f"Not shown: the change of {old.name}, which holds what CI runners take for a command")
    return ""


def _texts(old: Source, proposal: Proposal, findings: Iterable[Finding]) -> tuple[str, str]:
    """A file before and after, without secrets."""
    from bringup_lint.finding.redact import mask_of

    text = proposal.texts[os.path.abspath(old.name)].decode("utf-8")
    about = [found for found in findings if found.source.name == old.name]
    new = next((found.source for found in about if found.source.text == text), replace(old, text=text))
    mask = mask_of((found for found in about if found.source in (old, new)), (old, new))
    if mask:
        old, new = mask.source(old), mask.source(new)
    return old.text, new.text


def _diff(name: str, before: str, after: str, context: int) -> str:
    head = _quoted(name)
    lines = difflib.unified_diff(_lines(before), _lines(after), fromfile=head, tofile=head, n=context)
    return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines)


def _quoted(name: str) -> str:
    """A name as git and patch read it in a header, which it cannot end."""
    if name.isprintable() and not re.search(r'["\\]|##', name):
        return name
    return '"' + "".join(map(_octal, name)) + '"'


def _octal(character: str) -> str:
    if character in '"\\':
        return f"\\{character}"
    if character.isprintable() and character != "#":
        return character
    return "".join(f"\\{byte:03o}" for byte in os.fsencode(character))


def _lines(text: str) -> list[str]:
    """The lines as diff counts them: with their ends, and split at line feeds alone."""
    return [part + "\n" for part in text.split("\n")[:-1]] + list(filter(None, [text.rpartition("\n")[2]]))


def print_fixed(robot: Robot, outcome: Outcome, checked: Checked, options: RunOptions, *, unsafe: bool) -> int:
    """Fix standard input and print it; 1 when findings are left."""
    fixed: Counter[str] = Counter()
    seen: set[bytes] = set()
    rounds = Rounds(checked, unsafe)
    state = rounds.state_of(robot, outcome)
    for _ in range(ROUNDS):
        change = state.plan.changes.get(state.robot.sources[0].name)
        if change is None:
            break
        seen.add(options.stdin_data)
        options.stdin_data = change.new_text().encode()
        after = rounds.state_of(*checked())
        rules = {finding.rule for finding, _ in state.plan.taken}
        if _not_less(rules, state, after, options.stdin_data in seen):
            break
        fixed.update(finding.rule for finding, _ in state.plan.taken)
        state = after
    outcome = state.outcome
    click.echo(state.robot.sources[0].text, nl=False)
    _tell(fixed, state.plan)
    return 3 if outcome.failures else int(any(not found.suppression for found in outcome.findings))
