"""Whole robots: what is said about one that follows the guides, and that nothing is said about a good one."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.lint import lint

ROBOTS = PROJECT / "fixtures" / "robots"
ARGUMENTS = ("--root", ".", "--min-severity", "info", "--output-format", "concise", "/")


def names() -> list[str]:
    return sorted(path.parent.name for path in ROBOTS.glob("*/tree"))


@pytest.mark.parametrize("name", names())
def test_robot(name: str, update_expected: bool) -> None:
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
    run = lint(*ARGUMENTS, cwd=ROBOTS / "good" / "tree")
    assert run.stdout == ""
    assert run.code == 0


TRAPS = {
    "T1": ("systemd/key-in-wrong-section", "systemd/restart-unlimited", "systemd/onfailure-unreachable"),
    "T2": ("systemd/after-and-before-same", "systemd/ordering-cycle", "systemd/before-for-shutdown-order"),
    "T3": ("systemd/missing-required-unit", "systemd/install-bad-target", "systemd/onfailure-template-missing"),
    "T4": ("systemd/notify-ros-launch", "systemd/watchdog-without-notify", "systemd/notify-nobody-notifies"),
    "T5": ("systemd/final-kill-signal",),
    "T6": ("systemd/rt-limits-only-in-pam", "systemd/rt-starvation"),
    "T7": ("env/ros2-not-sourced", "systemd/restartsec-too-short", "systemd/kill-signal-not-sigint"),
    "T8": ("systemd/readwritepaths-missing", "systemd/privatetmp-redundant"),
    "T9": ("systemd/timeout-start-short",),
    "T12": ("systemd/robot-launch-overlap",),
    "T24": ("systemd/execstop-async-kill",),
    "T26": ("systemd/restart-on-failure-ros-launch",),
}
"""Mistakes in the guides' own examples, and the rules that find them."""


@pytest.mark.parametrize("trap", TRAPS)
def test_guide_robot_shows_the_trap(trap: str) -> None:
    text = Path(ROBOTS / "guide" / "expected.txt").read_text("utf-8")
    assert [rule for rule in TRAPS[trap] if f"[{rule}]" not in text] == []
