"""udev rules files, read as ``udevd`` reads them; an error costs its line."""

from __future__ import annotations

from bringup_lint.model.udev import Rule
from bringup_lint.model.udev import RulesFile
from bringup_lint.model.udev import Token
from bringup_lint.parsers.udev_keys import DROPPING
from bringup_lint.parsers.udev_keys import token_problems
from bringup_lint.parsers.udev_labels import label_problems
from bringup_lint.parsers.udev_lines import logical_lines
from bringup_lint.parsers.udev_tokens import read_tokens
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

_TEMPLATE_STATEMENTS = ("{%", "{#", "{{", "@", "%{", "<%")


def parse(source: Source) -> RulesFile:
    """All rules of a file. A template is read as far as it goes, and no problem is told of it."""
    rules: list[Rule] = []
    problems: list[Problem] = []
    owners: dict[int, Rule] = {}
    for line in logical_lines(source):
        if source.template and line.text.startswith(_TEMPLATE_STATEMENTS):
            continue
        rule, found = _read_rule(line.text, line.problem)
        rules.append(rule)
        for problem in found:
            owners[len(problems)] = rule
            problems.append(problem)
    for problem, rule in label_problems(rules):
        owners[len(problems)] = rule
        problems.append(problem)
    if source.template:
        return RulesFile(source, tuple(rules))
    return RulesFile(source, tuple(rules), tuple(problems), owners)


def _read_rule(text: Located, problem: Problem | None) -> tuple[Rule, list[Problem]]:
    tokens, unreadable = ([], None) if problem and problem.code == "line-too-long" else read_tokens(text)
    found = [told for told in (problem, unreadable) if told is not None]
    dropped = bool(found)
    for token in tokens:
        for told in token_problems(token):
            dropped = dropped or told.code in DROPPING
            found.append(told)
    if not dropped and not any(has_effect(token) for token in tokens):
        found.append(Problem("no-effect", text))
    return Rule(tuple(tokens), text.span, dropped), found


def has_effect(token: Token) -> bool:
    """Whether a line does something for this token: an assignment, a jump, a label, a program."""
    if token.key == "OPTIONS":
        return not any(told.code == "unknown-option" for told in token_problems(token))
    return not token.is_match or token.key in ("PROGRAM", "IMPORT")
