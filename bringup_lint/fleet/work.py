"""The work on all robots: in this process, or in worker processes that come and go, so that memory stays flat."""

from __future__ import annotations

import gc
import multiprocessing
from collections.abc import Iterable
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED
from concurrent.futures import Future
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures import wait
from concurrent.futures.process import BrokenProcessPool
from itertools import islice

from bringup_lint.fleet.check import Job
from bringup_lint.fleet.check import summary_of
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.summary import Summary
from bringup_lint.garbage import collect_seldom

AHEAD = 4
"""Robots that wait in line for each worker."""
TRIES = 3
"""How often a robot is tried whose worker died."""


def summaries(members: Iterable[Member], job: Job, workers: int) -> Iterator[Summary]:
    """The summary of each robot, as they are finished."""
    members = list(members)
    if workers < 2 or len(members) < 2:
        for member in members:
            yield summary_of(member, job)
            gc.collect()
        return
    left = {member.name: member for member in members}
    for _ in range(TRIES):
        for summary in _in_processes(list(left.values()), job, min(workers, len(left))):
            del left[summary.name]
            yield summary
        if not left:
            return
    for member in left.values():
        yield died(member)


def died(member: Member) -> Summary:
    """The summary of a robot whose worker died each time."""
    why = f"not checked: its worker died {TRIES} times"
    return Summary(member.name, member.role, member.site, member.domain, member.talks, failures=(why,))


def _in_processes(members: list[Member], job: Job, workers: int) -> Iterator[Summary]:
    """Ends early when a worker dies; what is missing then was not finished."""
    context = multiprocessing.get_context("spawn")
    waiting = iter(members)
    with ProcessPoolExecutor(workers, mp_context=context) as pool:
        running: set[Future[Summary]] = set()
        try:
            while True:
                for member in islice(waiting, workers * AHEAD - len(running)):
                    running.add(pool.submit(work, member, job))
                if not running:
                    return
                done, running = wait(running, return_when=FIRST_COMPLETED)
                for future in done:
                    yield future.result()
        except BrokenProcessPool:
            return


def work(member: Member, job: Job) -> Summary:
    """One robot in a worker, which gives its memory back before the next."""
    collect_seldom()
    summary = summary_of(member, job)
    gc.collect()
    return summary
