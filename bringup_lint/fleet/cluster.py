"""The work on all robots on a cluster of dask.distributed: a running one, or workers on this machine.

The scheduler retries what a worker that died had not finished. To the workers travel the members and the settings of
the run, with its key; back travel summaries. The workers read the robots themselves, so they need the same paths.
"""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import Any

from bringup_lint.config import ConfigError
from bringup_lint.extras import installed_by
from bringup_lint.fleet.check import Job
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.summary import Summary
from bringup_lint.fleet.work import TRIES
from bringup_lint.fleet.work import died
from bringup_lint.fleet.work import work

WAIT = 20
"""Seconds to wait for a scheduler."""
AHEAD = 1000
"""Robots that are handed out at a time."""


def on_cluster(robots: Iterable[Member | Summary], job: Job, address: str) -> Iterator[Summary]:
    """The summary of each robot, as they are finished; those that are known already as they come. ``local`` starts
    workers on this machine. Raises ConfigError when there is no scheduler, or no dask.distributed."""
    client = _client(address)
    try:
        yield from _finished(client, iter(robots), job)
    finally:
        client.close()


def _client(address: str) -> Any:
    try:
        from distributed import Client
        from distributed import LocalCluster
    except ImportError as error:
        raise ConfigError(f"--scheduler needs dask.distributed: {installed_by('fleet')}") from error
    try:
        if address == "local":
            return Client(LocalCluster(threads_per_worker=1, processes=True, dashboard_address=None))
        return Client(address, timeout=WAIT)
    except (OSError, ValueError) as error:
        raise ConfigError(f"--scheduler {address}: no scheduler answers there") from error


def _finished(client: Any, waiting: Iterator[Member | Summary], job: Job) -> Iterator[Summary]:
    from distributed import as_completed

    running: dict[Any, Member] = {}
    queue = as_completed(with_results=False)

    def hand_out() -> Iterator[Summary]:
        """One robot more; those that are known already come back at once."""
        for robot in waiting:
            if isinstance(robot, Summary):
                yield robot
                continue
            future = client.submit(work, robot, job, retries=TRIES, pure=False)
            running[future] = robot
            queue.add(future)
            return

    for _ in range(AHEAD):
        yield from hand_out()
    for future in queue:
        member = running.pop(future)
        yield future.result() if future.status == "finished" else died(member)
        yield from hand_out()
