"""The work on all robots: in this process, or in worker processes that come and go, so that memory stays flat."""

from __future__ import annotations

import gc
import multiprocessing
import os
from collections.abc import Generator
from collections.abc import Iterable
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED
from concurrent.futures import Future
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures import wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import suppress
from itertools import chain
from itertools import islice
from threading import Lock

from bringup_lint.fleet.check import Job
from bringup_lint.fleet.check import summary_of
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.summary import Summary
from bringup_lint.garbage import collect_seldom

AHEAD = 4
"""Robots that wait in line for each worker."""
TRIES = 3
"""How often a robot is tried whose worker died."""
_ONE_AT_A_TIME = Lock()


def summaries(robots: Iterable[Member | Summary], job: Job, workers: int) -> Iterator[Summary]:
    """The summary of each robot, as they are finished; those that are known already as they come."""
    waiting = iter(robots)
    first = list(islice(waiting, 2))
    waiting = chain(first, waiting)
    if workers < 2 or len(first) < 2:
        for robot in waiting:
            yield robot if isinstance(robot, Summary) else work(robot, job)
        return
    lost = yield from _in_processes(waiting, job, workers)
    while lost:
        yield from (_alone(member, job) for member in lost)
        lost = yield from _in_processes(waiting, job, workers)


def died(member: Member) -> Summary:
    """The summary of a robot whose worker died each time."""
    return failed(member, f"not checked: its worker died {TRIES} times")


def failed(member: Member, why: str) -> Summary:
    return Summary(member.name, member.role, member.site, member.domain, member.talks, failures=(why,))


def _in_processes(
    waiting: Iterator[Member | Summary], job: Job, workers: int
) -> Generator[Summary, None, list[Member]]:
    """Ends early when a worker dies; returns the robots that it, or another one, had not finished then."""
    running: dict[Future[Summary], Member] = {}
    with _pool(workers) as pool:
        try:
            while True:
                for robot in waiting:
                    if isinstance(robot, Summary):
                        yield robot
                        continue
                    running[_submitted(pool, robot, job)] = robot
                    if len(running) >= workers * AHEAD:
                        break
                if not running:
                    return []
                for future in wait(running, return_when=FIRST_COMPLETED).done:
                    yield future.result()
                    del running[future]
        except BrokenProcessPool:
            return list(running.values())


def _submitted(pool: ProcessPoolExecutor, member: Member, job: Job) -> Future[Summary]:
    """The future of a robot; one that says so when a worker has died before."""
    try:
        return pool.submit(work, member, job)
    except BrokenProcessPool as error:
        broken: Future[Summary] = Future()
        broken.set_exception(error)
        return broken


def _alone(member: Member, job: Job) -> Summary:
    """A robot that was not finished when a worker died, in a worker of its own: if that dies, too, it is this robot
    on which it does."""
    for _ in range(TRIES - 1):
        with _pool(1) as pool, suppress(BrokenProcessPool):
            return pool.submit(work, member, job).result()
    return died(member)


def _pool(workers: int) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))


def work(member: Member, job: Job) -> Summary:
    """One robot in a worker, which gives its memory back before the next. A worker of a cluster may have several
    threads, and another working folder."""
    with _ONE_AT_A_TIME:
        collect_seldom()
        before = os.getcwd()
        try:
            os.chdir(job.folder)
        except OSError as error:
            return failed(member, f"not checked: the worker has no '{job.folder}' ({error.strerror})")
        try:
            return summary_of(member, job)
        finally:
            os.chdir(before)
            gc.collect()
