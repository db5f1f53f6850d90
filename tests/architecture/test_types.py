"""mypy finds nothing wrong in the package and the rules."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.conftest import PROJECT


@pytest.mark.slow
def test_types_agree() -> None:
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy", "--no-error-summary"]
    run = subprocess.run(command, capture_output=True, text=True, cwd=PROJECT, check=False)
    assert run.stderr == ""
    assert [line for line in run.stdout.splitlines() if ": error:" in line] == []
