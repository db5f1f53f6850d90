"""Whole robots: what is said about one that follows the guides, and that nothing is said about a good one."""

from __future__ import annotations

import pytest

from bringup_lint.toml import read_toml
from tests.conftest import PROJECT
from tests.lint import lint
from tests.test_fixtures import set_modes

ROBOTS = PROJECT / "fixtures" / "robots"
ARGUMENTS = ("--root", ".", "--min-severity", "info", "--output-format", "concise", "/")


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


@pytest.mark.parametrize("trap", TRAPS)
def test_guide_robot_shows_the_trap(trap: str) -> None:
    lines = (ROBOTS / "guide" / "expected.txt").read_text("utf-8").splitlines()
    found = {(line.partition(":")[0], line.partition("[")[2].partition("]")[0]) for line in lines}
    assert [(file, rule) for rule, file in TRAPS[trap]["rules"].items() if (file, rule) not in found] == []
    assert TRAPS[trap]["what"]
