"""Nothing that a tool downloads or builds is kept in the repository."""

from __future__ import annotations

import shutil
import subprocess

import pytest

from tests.conftest import PROJECT

BINARY = ("docs/images/", "fixtures/", "tests/oracles/answers/")
"""Folders that hold files which are no text."""


def test_only_text_is_tracked() -> None:
    if not shutil.which("git") or not (PROJECT / ".git").exists():
        pytest.skip("the files are no checkout of git")
    run = subprocess.run(["git", "ls-files", "-z"], cwd=PROJECT, capture_output=True, text=True, check=True)
    paths = [PROJECT / name for name in run.stdout.split("\0") if name and not name.startswith(BINARY)]
    assert [path.name for path in paths if path.is_file() and b"\0" in path.read_bytes()] == []
