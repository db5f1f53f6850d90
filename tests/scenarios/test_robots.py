"""Whole robots: what is said about one that follows the guides, and that nothing is said about a good one."""

from __future__ import annotations

import pytest

from bringup_lint.toml import read_toml
from tests.conftest import PROJECT
from tests.lint import lint
from tests.rules.test_fixtures import set_modes

ROBOTS = PROJECT / "fixtures" / "robots"
ARGUMENTS = ("--root", ".", "--now", "2026-06-01", "--min-severity", "info", "--output-format", "concise", "/")


def names() -> list[str]:
    return sorted(path.parent.name for path in ROBOTS.glob("*/tree"))


@pytest.mark.parametrize("name", names())
def test_robot(name: str, update_expected: bool) -> None:
    set_modes(ROBOTS / name)
    expected = ROBOTS / name / "expected.txt"
    run = lint(*ARGUMENTS, cwd=ROBOTS / name / "tree")
    assert run.code in (0, 1), run.stderr
    if update_expected:
        expected.write_text(run.stdout, "utf-8")
    assert run.stdout == expected.read_text("utf-8")


@pytest.mark.parametrize("name", names())
def test_robot_says_what_it_is(name: str) -> None:
    assert (ROBOTS / name / "README.md").read_text("utf-8").startswith("# ")


def test_good_robot_is_silent() -> None:
    set_modes(ROBOTS / "good")
    run = lint(*ARGUMENTS, cwd=ROBOTS / "good" / "tree")
    assert run.stdout == ""
    assert run.code == 0


TRAPS = read_toml((ROBOTS / "guide" / "traps.toml").read_text("utf-8"))
"""Mistakes in the guides' own examples, and the rules that find them, each with its file."""


@pytest.fixture(scope="module")
def found() -> set[tuple[str, str]]:
    """File and rule of what is said about the robot that follows the guides."""
    lines = (ROBOTS / "guide" / "expected.txt").read_text("utf-8").splitlines()
    return {(line.partition(":")[0], line.partition("[")[2].partition("]")[0]) for line in lines}


@pytest.mark.parametrize("trap", TRAPS)
def test_guide_robot_shows_the_trap(trap: str, found: set[tuple[str, str]]) -> None:
    entry = TRAPS[trap]
    assert entry["what"] and set(entry) - {"what"} <= {"rules", "fixtures", "silent"} and len(entry) > 1
    assert [(file, rule) for rule, file in entry.get("rules", {}).items() if (file, rule) not in found] == []


@pytest.mark.parametrize("trap", [trap for trap in TRAPS if "fixtures" in TRAPS[trap]])
def test_what_the_robot_cannot_have_is_shown_by_a_fixture(trap: str) -> None:
    for rule, folder in TRAPS[trap]["fixtures"].items():
        assert folder.startswith(f"fixtures/{rule.replace('-', '_')}/bad") and (PROJECT / folder).is_dir()


@pytest.mark.parametrize("trap", [trap for trap in TRAPS if "silent" in TRAPS[trap]])
def test_what_is_right_stays_unsaid(trap: str, found: set[tuple[str, str]]) -> None:
    for file, rules in TRAPS[trap]["silent"].items():
        assert (ROBOTS / "guide" / "tree" / file).is_file()
        assert [rule for rule in rules if (file, rule) in found] == []


def test_no_trap_is_left_out() -> None:
    numbers = {"T": 30, "R": 50, "N": 8}
    assert list(TRAPS) == [f"{kind}{number}" for kind, last in numbers.items() for number in range(1, last + 1)]
