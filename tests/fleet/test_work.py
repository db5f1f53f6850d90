"""What a worker does beside its robot."""

from __future__ import annotations

import gc
import pickle
import subprocess
import sys
from collections.abc import Iterator
from datetime import date
from pathlib import Path

import pytest

from bringup_lint.config import Config
from bringup_lint.fleet.check import Job
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.summary import Fact
from bringup_lint.fleet.summary import Summary
from bringup_lint.fleet.work import work
from bringup_lint.garbage import YOUNG_OBJECTS
from tests.conftest import PROJECT


@pytest.fixture(autouse=True)
def threshold_is_put_back() -> Iterator[None]:
    before = gc.get_threshold()
    yield
    gc.set_threshold(*before)


def test_a_worker_searches_for_garbage_as_seldom_as_the_command_does(tmp_path: Path) -> None:
    (tmp_path / "etc").mkdir()
    gc.set_threshold(700, 10, 10)
    work(Member("alpha", (str(tmp_path),)), Job(Config(), b"k" * 32, date(2026, 1, 1)))
    assert gc.get_threshold()[0] == YOUNG_OBJECTS


READ = """
import pickle, sys
from bringup_lint.fleet.summary import from_data, to_data
summary = pickle.loads(sys.stdin.buffer.read())
assert from_data(to_data(summary)) == summary
"""


def test_the_summary_of_a_worker_can_be_kept_by_a_process_that_made_none() -> None:
    summary = Summary("alpha", "rover", facts=(Fact("host-name", "", "alpha", "etc/hostname", 1),))
    subprocess.run([sys.executable, "-c", READ], input=pickle.dumps(summary), check=True, cwd=PROJECT)
