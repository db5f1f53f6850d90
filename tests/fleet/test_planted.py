"""Generated fleets with planted defects: everything is found, and nothing else."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.fleet.test_fleet import judged


@pytest.mark.parametrize(("robots", "drivers"), [(3, 0), (4, 1), pytest.param(50, 0, marks=pytest.mark.slow)])
def test_planted_defects_are_found_and_nothing_else(
    robots: int, drivers: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.syspath_prepend(str(PROJECT / "benchmarks"))
    monkeypatch.delitem(sys.modules, "fleet", raising=False)
    planted = importlib.import_module("fleet")
    expected = planted.plant(tmp_path, robots, drivers)
    assert planted.answers(judged("--select", "fleet", ".", cwd=tmp_path)) == expected
