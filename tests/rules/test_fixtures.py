"""Every rule finds its bad fixture, line for line, and is silent on its good one."""

from __future__ import annotations

import os
import re
from functools import cache
from pathlib import Path

import pytest

from bringup_lint.registry import Registry
from tests.conftest import PROJECT
from tests.lint import lint

pytestmark = pytest.mark.usefixtures("settled")

FIXTURES = PROJECT / "fixtures"
BY_ENGINE = {"lint/internal-error", "lint/time-budget"}
"""Reported by the engine about itself; tested where a rule is made to fail, or to never end."""

RULE_IDS = sorted(Registry.of().paths)


def folder_of(rule_id: str) -> Path:
    return FIXTURES / rule_id.replace("-", "_")


def cases_of(rule_id: str, prefix: str) -> list[Path]:
    """The folders ``bad``, ``bad_dropin`` and so on."""
    return [case for case in all_cases_of(rule_id) if case.name.partition("_")[0] == prefix]


@cache
def all_cases_of(rule_id: str) -> list[Path]:
    folder = folder_of(rule_id)
    entries = os.scandir(folder) if folder.is_dir() else ()
    return [folder / name for name in sorted(entry.name for entry in entries if entry.is_dir())]


def cases(prefix: str) -> list[tuple[str, Path]]:
    return [(rule_id, case) for rule_id in RULE_IDS for case in cases_of(rule_id, prefix)]


def arguments(case: Path) -> list[str]:
    """What is checked: the folder, or what its ``arguments.txt`` says; of a fleet its inventory, or each folder of
    ``robots/``."""
    own = case / "arguments.txt"
    robots = case / "robots"
    if case.parent.parent.name == "fleet" and not own.exists():
        return ["."] if (case / "fleet.toml").exists() else sorted(f"robots/{path.name}" for path in robots.iterdir())
    return own.read_text("utf-8").split() if own.exists() else ["."]


def command(rule_id: str) -> list[str]:
    """Rules on the running graph get one that was saved."""
    if rule_id.startswith("fleet/"):
        return ["fleet", "--workers", "1"]
    return ["live", "--load", "graph.yaml"] if rule_id.startswith("live/") else []


def set_modes(case: Path) -> None:
    """Give files the permissions of ``modes.txt`` (``0666 etc/x``), which git does not keep."""
    modes = case / "modes.txt"
    for line in modes.read_text("utf-8").splitlines() if modes.exists() else ():
        mode, _, name = line.partition(" ")
        (case / name).chmod(int(mode, 8))


def case_id(value: object) -> str:
    return value.name if isinstance(value, Path) else str(value)


def test_every_rule_has_a_bad_and_a_good_fixture() -> None:
    wanted = [(rule_id, prefix) for rule_id in sorted(set(RULE_IDS) - BY_ENGINE) for prefix in ("bad", "good")]
    assert [f"{folder_of(rule_id)}/{prefix}/" for rule_id, prefix in wanted if not cases_of(rule_id, prefix)] == []


@pytest.mark.parametrize(("rule_id", "case"), cases("bad"), ids=case_id)
def test_bad_fixture(rule_id: str, case: Path, update_expected: bool) -> None:
    set_modes(case)
    expected = case.parent / case.name.replace("bad", "expected", 1).__add__(".txt")
    run = lint(*command(rule_id), "--select", rule_id, "--output-format", "concise", *arguments(case), cwd=case)
    assert run.code in (0, 1), run.stderr
    if update_expected:
        expected.write_text(run.stdout, "utf-8")
    assert f"[{rule_id}]" in run.stdout
    assert run.stdout == expected.read_text("utf-8")


@pytest.mark.parametrize(("rule_id", "case"), cases("good"), ids=case_id)
def test_good_fixture(rule_id: str, case: Path) -> None:
    assert any(path.is_file() or path.is_symlink() for path in case.rglob("*")), f"{case} is empty"
    set_modes(case)
    run = lint(*command(rule_id), "--select", rule_id, "--output-format", "concise", *arguments(case), cwd=case)
    assert run.stdout == ""
    assert run.code == 0, run.stderr


def test_every_fixture_belongs_to_a_rule() -> None:
    known = {folder_of(rule_id) for rule_id in RULE_IDS} | {FIXTURES / "robots"}
    folders = {
        path for family in FIXTURES.iterdir() if family.name not in ("robots", "hostile") for path in family.iterdir()
    }
    assert folders <= known


LOWER_CASE = re.compile(r"\] (?:an?|the|this|these|no|none|nobody|nothing|if|what|when|where|every|each|there|two|it) ")


def test_messages_begin_as_sentences() -> None:
    lines = [line for path in FIXTURES.glob("*/*/expected*.txt") for line in path.read_text("utf-8").splitlines()]
    assert [line for line in lines if LOWER_CASE.search(line)] == []
