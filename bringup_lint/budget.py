"""How much CPU time a part of a run may take: the last resort against trees that would keep a run busy forever.

No real tree comes near; the loops over untrusted text have limits of their own, which count steps. What exceeds its
budget becomes a finding of ``lint/time-budget``.
"""

from __future__ import annotations

import signal
import sys
import time
from types import FrameType

FILE = 120.0
"""CPU seconds in which one file must be parsed."""
RULE = 300.0
"""CPU seconds of one rule, with what it is the first to ask for."""
RUN = 1200.0
"""CPU seconds of all rules."""

_SHORTEST = 0.001
"""CPU seconds for what has nothing left: a timer of none would never ring."""
_active = 0
_handled = 0


class OutOfTime(BaseException):
    """A budget is spent. Not an ``Exception``, so that nothing that isolates failures takes it for one."""


class handled:
    """Look once whether the signal of the timer is ours, for all limits that follow each other inside."""

    def __enter__(self) -> None:
        global _handled
        if _has_timers():
            _take_signal()
            _handled += 1

    def __exit__(self, *_: object) -> None:
        global _handled
        if _has_timers():
            _handled -= 1


class limited:
    """Raise OutOfTime after so many CPU seconds of this process, or when an outer limit ends, which then raises again
    outside. Only the main thread of a system with timers can be interrupted; elsewhere there is no limit."""

    __slots__ = ("_is_set", "_outer", "_seconds", "_started")

    def __init__(self, seconds: float) -> None:
        self._seconds = seconds

    def __enter__(self) -> None:
        global _active
        self._is_set = _has_timers()
        if not self._is_set:
            return
        if not _active and not _handled:
            _take_signal()
        self._started = time.process_time()
        _active += 1
        seconds = self._seconds
        self._outer = signal.setitimer(signal.ITIMER_PROF, max(_SHORTEST, seconds))[0]
        if self._outer and self._outer < seconds:
            signal.setitimer(signal.ITIMER_PROF, max(_SHORTEST, self._outer))

    def __exit__(self, *_: object) -> None:
        global _active
        if self._is_set:
            left = self._outer and max(_SHORTEST, self._outer - (time.process_time() - self._started))
            signal.setitimer(signal.ITIMER_PROF, left)
            _active -= 1


def _has_timers() -> bool:
    threading = sys.modules.get("threading")  # without it, there is no other thread
    return hasattr(signal, "setitimer") and (not threading or threading.current_thread() is threading.main_thread())


def _take_signal() -> None:
    if signal.getsignal(signal.SIGPROF) is not _stop:
        signal.signal(signal.SIGPROF, _stop)


def _stop(number: int, frame: FrameType | None) -> None:
    if _active:
        raise OutOfTime
