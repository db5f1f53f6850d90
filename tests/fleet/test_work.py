"""What a worker does beside its robot."""

from __future__ import annotations

import gc
import os
import pickle
import signal
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
from bringup_lint.fleet.work import summaries
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


def kill_on_some(member: Member, job: Job) -> Summary:
    """In place of the check: two robots on which each worker dies."""
    if member.name in ("rover-03", "rover-10"):
        os.kill(os.getpid(), signal.SIGKILL)
    return Summary(member.name, member.role)


@pytest.mark.slow
def test_a_robot_that_kills_its_workers_costs_no_other(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bringup_lint.fleet.work.work", kill_on_some)
    members = [Member(f"rover-{number:02}", ("/",)) for number in range(20)]
    known = Summary("rover-20", "known")
    found = {each.name: each for each in summaries([known, *members], Job(Config(), b"k" * 32, date(2026, 1, 1)), 2)}
    assert sorted(found) == [f"rover-{number:02}" for number in range(21)]
    assert found["rover-20"] is known
    assert {name: each.failures for name, each in found.items() if each.failures} == {
        name: ("not checked: its worker died 3 times",) for name in ("rover-03", "rover-10")
    }


def test_a_worker_without_the_folder_of_the_run_says_so(tmp_path: Path) -> None:
    job = Job(Config(), b"k" * 32, date(2026, 1, 1), folder=str(tmp_path / "gone"))
    summary = work(Member("alpha", (str(tmp_path),)), job)
    assert summary.failures == (f"not checked: the worker has no '{tmp_path}/gone' (No such file or directory)",)
