"""What every rule file must say about itself."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache

from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.registry import described
from bringup_lint.registry import load
from bringup_lint.report.docs import HEADINGS


@cache
def rules() -> list[Rule]:
    registry = Registry.of()
    return [load(path, rule_id) for rule_id, path in sorted(registry.paths.items())]


def other_than(holds: Callable[[Rule], bool]) -> list[str]:
    """The rules for which something does not hold."""
    return [rule.id for rule in rules() if not holds(rule)]


def section(rule: Rule, heading: str) -> str:
    return rule.doc.partition(f"## {heading}\n")[2].partition("\n## ")[0]


def imported(rule: Rule) -> set[str]:
    """The modules of the package that the file of a rule imports."""
    tree = ast.parse(rule.path.read_text("utf-8"))
    nodes = [*ast.walk(tree)]
    modules = {node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)}
    modules |= {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    return {module for module in modules if module.startswith("bringup_lint")}


def test_docstring_has_the_fixed_headings_in_order() -> None:
    assert other_than(lambda rule: tuple(re.findall(r"^## (.+)$", rule.doc, re.M)) == HEADINGS) == []


def test_sections_say_something() -> None:
    assert other_than(lambda rule: all(part.strip() for part in re.split(r"^## .+$", rule.doc, flags=re.M)[1:])) == []


def test_bad_and_good_are_code_blocks() -> None:
    assert other_than(lambda rule: all("```" in section(rule, heading) for heading in ("Bad", "Good"))) == []


def test_title_is_one_sentence() -> None:
    assert other_than(lambda rule: 10 <= len(rule.title) <= 100 and "\n" not in rule.title) == []


def test_rule_imports_only_the_api() -> None:
    own = re.compile(r"bringup_lint\.api(\..+)?")
    assert other_than(lambda rule: all(map(own.fullmatch, imported(rule)))) == []


def test_function_is_named_after_the_file() -> None:
    assert other_than(lambda rule: rule.check.__name__ == rule.path.stem) == []


def test_function_is_typed() -> None:
    def is_typed(rule: Rule) -> bool:
        fleet = rule.family == "fleet"
        types = "fleet: Fleet) -> Iterator[FleetFinding]" if fleet else "robot: Robot) -> Iterator[Finding]"
        return f"def {rule.path.stem}({types}:\n" in rule.path.read_text("utf-8")

    assert other_than(is_typed) == []


def test_each_rule_knows_a_log_line_or_says_why_there_is_none() -> None:
    assert other_than(lambda rule: bool(rule.meta.symptoms) != bool(rule.meta.silent)) == []


def test_the_reason_for_silence_continues_a_sentence() -> None:
    reasons = [rule.meta.silent for rule in rules() if rule.meta.silent]
    assert [reason for reason in reasons if reason.endswith(".") or not 10 <= len(reason) <= 100] == []


def test_cwe_tags_are_well_formed() -> None:
    tags = {tag for rule in rules() for tag in rule.meta.tags if tag.upper().startswith("CWE")}
    assert [tag for tag in tags if not re.fullmatch(r"CWE-\d+", tag)] == []


def test_what_a_rule_file_says_of_itself_is_what_it_is_when_it_is_loaded() -> None:
    for loaded in rules():
        rule = described(loaded.path, loaded.id)
        assert rule.doc == loaded.doc
        assert replace(rule.meta, check=loaded.check) == loaded.meta, rule.id


def calls_fix(rule: Rule) -> bool:
    text = rule.path.read_text("utf-8")
    if "fix(" not in text:
        return False
    tree = ast.parse(text)
    calls = (node.func for node in ast.walk(tree) if isinstance(node, ast.Call))
    return any(isinstance(name, ast.Name) and name.id == "fix" for name in calls)


def test_what_has_a_fix_says_so() -> None:
    assert other_than(lambda rule: not calls_fix(rule) or rule.meta.fix != "none") == []
