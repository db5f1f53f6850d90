"""mypy finds nothing wrong in the package and the rules."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import PROJECT


@pytest.mark.slow
def test_types_agree(tmp_path: Path) -> None:
    """No cache appears in the folder of the project: it is in ``sys.path``, and the tests of the cache, which may run
    beside, see each change of it."""
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy", "--no-error-summary", "--cache-dir", str(tmp_path / "cache")]
    run = subprocess.run(command, capture_output=True, text=True, cwd=PROJECT, check=False)
    assert run.stderr == ""
    assert [line for line in run.stdout.splitlines() if ": error:" in line] == []
