"""One queue of work for the main thread: whatever reads files or asks a robot, one after the other."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import Future
from queue import SimpleQueue
from typing import Any
from typing import TypeVar

from bringup_lint.garbage import collect_between_runs

Result = TypeVar("Result")


class Worker:
    """Runs what other threads ask for in the thread that calls ``run``. Only the main thread can be interrupted when a
    budget of CPU time is spent, and only one run at a time may name files from its working folder."""

    def __init__(self) -> None:
        self._jobs: SimpleQueue[tuple[Future[Any], Callable[[], Any]] | None] = SimpleQueue()

    async def do(self, work: Callable[[], Result]) -> Result:
        """The result of some work. When the caller is cancelled before it begins, it is not done."""
        future: Future[Result] = Future()
        self._jobs.put((future, work))
        return await asyncio.wrap_future(future)

    def run(self) -> None:
        """Work until ``stop`` is called."""
        collect_between_runs()
        while (job := self._jobs.get()) is not None:
            future, work = job
            if future.set_running_or_notify_cancel():
                _fulfil(future, work)

    def stop(self) -> None:
        self._jobs.put(None)


def _fulfil(future: Future[Result], work: Callable[[], Result]) -> None:
    try:
        future.set_result(work())
    except Exception as error:
        future.set_exception(error)
