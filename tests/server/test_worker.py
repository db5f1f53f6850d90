"""The thread of the server that reads robots, one after the other."""

from __future__ import annotations

import gc

from bringup_lint.garbage import OF_MANY_RUNS
from bringup_lint.garbage import collect_seldom
from bringup_lint.server.worker import Worker


def test_robots_of_earlier_runs_do_not_pile_up() -> None:
    before = gc.get_threshold()
    worker = Worker()
    worker.stop()
    collect_seldom()
    try:
        worker.run()
        assert gc.get_threshold()[0] == OF_MANY_RUNS
    finally:
        gc.set_threshold(*before)
