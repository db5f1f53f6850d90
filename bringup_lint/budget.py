"""How much CPU time a part of a run may take: the last resort against trees that would keep a run busy forever.

No real tree comes near; the loops over untrusted text have limits of their own, which count steps. What exceeds its
budget becomes a finding of ``lint/time-budget``.
"""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

FILE = 120.0
"""CPU seconds in which one file must be parsed."""
RULE = 300.0
"""CPU seconds of one rule, with what it is the first to ask for."""
RUN = 1200.0
"""CPU seconds of all rules."""

_active = 0


class OutOfTime(BaseException):
    """A budget is spent. Not an ``Exception``, so that nothing that isolates failures takes it for one."""


@contextmanager
def limited(seconds: float) -> Iterator[None]:
    """Raise OutOfTime after so many CPU seconds of this process, or when an outer limit ends, which then raises again
    outside. Only the main thread of a system with timers can be interrupted; elsewhere there is no limit."""
    global _active
    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return
    if signal.getsignal(signal.SIGPROF) is not _stop:
        signal.signal(signal.SIGPROF, _stop)
    outer = signal.getitimer(signal.ITIMER_PROF)[0]
    started = time.process_time()
    _active += 1
    signal.setitimer(signal.ITIMER_PROF, max(0.001, min(seconds, outer) if outer else seconds))
    try:
        yield
    finally:
        left = outer and max(0.001, outer - (time.process_time() - started))
        signal.setitimer(signal.ITIMER_PROF, left)
        _active -= 1


def _stop(number: int, frame: FrameType | None) -> None:
    if _active:
        raise OutOfTime
