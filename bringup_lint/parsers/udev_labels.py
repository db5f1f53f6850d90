"""GOTO and LABEL of one rules file."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.model.udev import Rule
from bringup_lint.model.udev import Token
from bringup_lint.source import Problem


def goto_of(rule: Rule) -> Token | None:
    """The GOTO that counts: the first one of a line."""
    return next(iter(rule.assignments("GOTO")), None)


def label_of(rule: Rule) -> Token | None:
    """The LABEL that counts: the last one of a line."""
    return next(reversed(rule.assignments("LABEL")), None)


def targets(rules: Sequence[Rule]) -> dict[int, int]:
    """From the index of each rule with a GOTO to that of the rule below with its label."""
    below: dict[str, int] = {}
    found: dict[int, int] = {}
    for index in range(len(rules) - 1, -1, -1):
        rule = rules[index]
        if rule.dropped:
            continue
        goto = goto_of(rule)
        if goto is not None and goto.value in below:
            found[index] = below[goto.value]
        label = label_of(rule)
        if label is not None:
            below[label.value] = index
    return found


def label_problems(rules: Sequence[Rule]) -> Iterator[tuple[Problem, Rule]]:
    found = targets(rules)
    used = set(found.values())
    labels = {label.value: label for rule in rules if not rule.dropped and (label := label_of(rule))}
    for index, rule in enumerate(rules):
        if rule.dropped:
            continue
        goto = goto_of(rule)
        if goto is not None and index not in found:
            yield Problem("goto-backward" if goto.value in labels else "goto-without-label", goto.value), rule
        label = label_of(rule)
        if label is not None and index not in used:
            yield Problem("label-unused", label.value), rule
        for key in ("GOTO", "LABEL"):
            several = rule.assignments(key)
            if len(several) > 1:
                yield Problem("second-jump", several[1].span, key), rule
