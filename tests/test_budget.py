"""Limits of CPU time, one inside of another."""

from __future__ import annotations

import signal
import threading

import pytest

from bringup_lint.budget import OutOfTime
from bringup_lint.budget import limited

SOON = 0.01
LATE = 60.0


def spin() -> None:
    while True:
        pass


def test_what_takes_too_long_is_stopped() -> None:
    with pytest.raises(OutOfTime), limited(SOON):
        spin()


def test_an_outer_limit_ends_what_is_inside() -> None:
    with pytest.raises(OutOfTime), limited(SOON), limited(LATE):
        spin()


def test_an_outer_limit_goes_on_after_an_inner_one() -> None:
    with pytest.raises(OutOfTime), limited(SOON):
        with limited(LATE):
            pass
        spin()


def test_an_inner_limit_leaves_the_outer_one_alone() -> None:
    with limited(LATE):
        with pytest.raises(OutOfTime), limited(SOON):
            spin()
        assert SOON < signal.getitimer(signal.ITIMER_PROF)[0] <= LATE


def test_what_has_no_time_left_is_stopped() -> None:
    with pytest.raises(OutOfTime), limited(0.0):
        spin()


def test_no_timer_is_left_behind() -> None:
    with limited(SOON):
        pass
    assert signal.getitimer(signal.ITIMER_PROF)[0] == 0


def test_another_thread_has_no_limit() -> None:
    timers: list[float] = []

    def work() -> None:
        with limited(SOON):
            timers.append(signal.getitimer(signal.ITIMER_PROF)[0])

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert timers == [0.0]
