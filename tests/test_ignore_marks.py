"""Comments that silence findings say nothing to the rules that search a text."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from bringup_lint.ignore_marks import without_marks
from bringup_lint.source import Source
from tests.conftest import PROJECT
from tests.growth import is_linear
from tests.lint import lint


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a\n# bringup-lint: ignore[b/c]: why\nd\n", "a\n\nd\n"),
        ("a # bringup-lint: ignore[b/c]: why - not\r\nd", "a\r\nd"),
        ("a // bringup-lint: ignore-file[b]\n", "a\n"),
        ("<a/> <!-- bringup-lint: ignore[b/c]: why --> <d/>", "<a/> <!-- --> <d/>"),
        ("# bringup-lint: ignore[b] # bringup-lint: ignore[c]: d\ne", "\ne"),
        ("echo bringup-lint: ignore[b]\n", "echo bringup-lint: ignore[b]\n"),
        ("# bringup-lint: checks this\n", "# bringup-lint: checks this\n"),
    ],
)
def test_what_is_left(text: str, said: str) -> None:
    left = Source("x", text).said
    assert len(left) == len(text)
    assert " ".join(left.split(" ")).replace(" ", "") == said.replace(" ", "")


@pytest.mark.parametrize(
    "unit", ["# bringup-lint: ignore[a] ", "<!-- bringup-lint: ignore[a]: -", "bringup-lint:", "# "]
)
def test_marks_are_found_in_linear_time(unit: str) -> None:
    assert is_linear(lambda size: without_marks("bringup-lint:" + unit * size), 1000)


@pytest.mark.parametrize(
    ("rule", "reason"),
    [
        ("env/zenoh-router-missing", "zenohd, the zenoh-router, runs on the base"),
        ("script/udev-not-reloaded", "udevadm trigger is run by hand"),
        ("script/can-setup-unchecked", "set -e is not wanted"),
        ("systemd/timer-only-unit-active", "a comment that names robot.service"),
    ],
)
def test_a_reason_changes_no_finding(rule: str, reason: str, tmp_path: Path) -> None:
    folder = tmp_path / "tree"
    shutil.copytree(PROJECT / "fixtures" / rule.replace("-", "_") / "bad", folder)
    before = lint("--select", rule, "--output-format", "concise", cwd=folder).stdout
    assert before
    lint("--select", rule, "--add-ignores", reason, cwd=folder)
    again = lint("--select", f"{rule},lint", "--no-ignores", "--output-format", "concise", cwd=folder).stdout
    assert again.count(f"[{rule}]") == before.count(f"[{rule}]")
    assert lint("--select", f"{rule},lint", "--output-format", "concise", cwd=folder).stdout == ""
