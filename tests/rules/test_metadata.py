"""What every rule file must say about itself."""

from __future__ import annotations

import ast
import re
from dataclasses import replace
from functools import cache

import pytest

from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.registry import described
from bringup_lint.registry import load
from bringup_lint.report.docs import HEADINGS

REGISTRY = Registry.of()
loaded = cache(REGISTRY.get)


@pytest.fixture(params=sorted(REGISTRY.paths))
def rule(request: pytest.FixtureRequest) -> Rule:
    return loaded(request.param)


def test_docstring_has_the_fixed_headings_in_order(rule: Rule) -> None:
    headings = tuple(re.findall(r"^## (.+)$", rule.doc, re.M))
    assert headings == HEADINGS


def test_sections_say_something(rule: Rule) -> None:
    sections = re.split(r"^## .+$", rule.doc, flags=re.M)[1:]
    assert all(section.strip() for section in sections)


def test_bad_and_good_are_code_blocks(rule: Rule) -> None:
    for heading in ("Bad", "Good"):
        section = rule.doc.partition(f"## {heading}\n")[2].partition("\n## ")[0]
        assert "```" in section, f"{heading} needs a code block"


def test_title_is_one_sentence(rule: Rule) -> None:
    assert 10 <= len(rule.title) <= 100
    assert "\n" not in rule.title


def test_rule_imports_only_the_api(rule: Rule) -> None:
    tree = ast.parse(rule.path.read_text("utf-8"))
    modules = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    modules |= {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
    own = {module for module in modules if module and module.startswith("bringup_lint")}
    assert all(module.split(".")[:2] == ["bringup_lint", "api"] for module in own)


def test_function_is_named_after_the_file(rule: Rule) -> None:
    assert rule.check.__name__ == rule.path.stem


def test_function_is_typed(rule: Rule) -> None:
    types = (
        "fleet: Fleet) -> Iterator[FleetFinding]" if rule.family == "fleet" else "robot: Robot) -> Iterator[Finding]"
    )
    assert f"def {rule.path.stem}({types}:\n" in rule.path.read_text("utf-8")


def test_cwe_tags_are_well_formed(rule: Rule) -> None:
    assert all(re.fullmatch(r"CWE-\d+", tag) for tag in rule.meta.tags if tag.upper().startswith("CWE"))


def test_what_a_rule_file_says_of_itself_is_what_it_is_when_it_is_loaded() -> None:
    for rule_id, path in Registry.of().paths.items():
        rule, loaded = described(path, rule_id), load(path, rule_id)
        assert rule.doc == loaded.doc
        assert replace(rule.meta, check=loaded.check) == loaded.meta, rule_id
