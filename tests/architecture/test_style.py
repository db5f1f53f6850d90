"""The code keeps the style that ``pyproject.toml`` asks for."""

from __future__ import annotations

import subprocess
import sys

import pytest

from bringup_lint.pattern import regex
from tests.conftest import PROJECT


@pytest.mark.parametrize(
    "command", [["check", "--no-cache"], ["format", "--check", "--no-cache"]], ids=["check", "format"]
)
def test_ruff_agrees(command: list[str]) -> None:
    pytest.importorskip("ruff")
    run = subprocess.run([sys.executable, "-m", "ruff", *command, "."], cwd=PROJECT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout


LITERAL = regex(
    r"\b(?:stands (?:twice|behind|above|before)|is no (?:address|number|path)|for ever|held against|living robot|mended"
    r"|bred)\b"
)
"""Words that are not those of the documentation of systemd, ruff or ROS 2."""


def test_english_is_plain() -> None:
    pages = [*PROJECT.glob("*.md"), *PROJECT.glob("docs/**/*.md"), *PROJECT.glob("bringup_lint/**/*.py")]
    pages += PROJECT.glob("rules/*/*.py")
    found = [(path.name, match[0]) for path in pages for match in LITERAL.finditer(path.read_text("utf-8"))]
    assert found == []
