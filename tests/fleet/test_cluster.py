"""A real scheduler and real workers on the loopback, one of which is killed in the middle of its work."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.fleet.test_fleet import write
from tests.lint import lint

pytestmark = pytest.mark.slow
UNIT = "[Unit]\nAfter=network.target\n\n[Service]\nExecStart=/opt/ros/jazzy/bin/ros2 launch rover up.launch.py\n"


def start(module: str, *arguments: str) -> subprocess.Popen[str]:
    paths = os.pathsep.join([str(PROJECT), *filter(None, [os.environ.get("PYTHONPATH")])])
    command = [sys.executable, "-m", f"distributed.cli.{module}", "--no-dashboard", *arguments]
    environment = {**os.environ, "PYTHONPATH": paths}
    return subprocess.Popen(command, cwd="/", env=environment, stderr=subprocess.PIPE, text=True)


@pytest.fixture
def scheduler() -> Iterator[str]:
    pytest.importorskip("distributed")
    process = start("dask_scheduler", "--host", "127.0.0.1", "--port", "0")
    assert process.stderr is not None
    said = (re.search(r"tcp://127\.0\.0\.1:\d+", line) for line in process.stderr)
    yield next(found[0] for found in said if found)
    process.kill()
    process.wait()


def test_a_worker_that_dies_costs_no_result(scheduler: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from bringup_lint.fleet import cluster

    names = [f"rover-{number:02}" for number in range(12)]
    for name in names:
        write(tmp_path, {f"{name}/etc/machine-id": "0" * 32, f"{name}/etc/systemd/system/rover.service": UNIT})
    arguments = ["fleet", "--output-format", "json", *names]
    alone = lint(*arguments, "--workers", "1", cwd=tmp_path)
    options = ("--nthreads", "1", "--no-nanny", "--death-timeout", "60")
    workers = [start("dask_worker", scheduler, *options) for _ in range(2)]
    finished = cluster._finished

    def killing(*given):  # type: ignore[no-untyped-def]
        for number, summary in enumerate(finished(*given)):
            if number == 2:
                workers[0].send_signal(signal.SIGKILL)
            yield summary

    monkeypatch.setattr(cluster, "_finished", killing)
    try:
        together = lint(*arguments, "--scheduler", scheduler, cwd=tmp_path)
    finally:
        for worker in workers:
            worker.kill()
            worker.wait()
    assert workers[0].returncode == -signal.SIGKILL
    assert together.stdout == alone.stdout
    assert together.code == alone.code == 1
