"""The restart arithmetic against a simulation of systemd's rate limit."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.discover.walk import discover
from bringup_lint.graph.systemd.restart import RestartPolicy
from bringup_lint.robot import Robot

STARTS = 400


def policy(delay: float, interval: float, burst: int, steps: int = 0, longest: float | None = None) -> RestartPolicy:
    longest = delay if longest is None else longest
    return RestartPolicy("always", None, delay, None, steps, longest, interval, None, burst, None)


def trips(policy: RestartPolicy, fail: float = 0.0) -> bool:
    """``ratelimit_below()`` of systemd, start by start, with an exact clock."""
    if not policy.interval or not policy.burst:
        return False
    begin, number, now = None, 0, 1.0
    for start in range(1, STARTS):
        if begin is None or now - begin > policy.interval:
            begin, number = now, 1
        else:
            number += 1
            if number > policy.burst:
                return True
        now += fail + policy.next_delay(start)
    return False


whole = st.integers(0, 40).map(float)


@given(whole, whole, st.integers(0, 12))
def test_never_trips_is_what_the_rate_limit_does(delay: float, interval: float, burst: int) -> None:
    found = policy(delay, interval, burst)
    assert found.never_trips is not trips(found)


@given(st.integers(1, 10), st.integers(1, 60), st.integers(1, 8), st.integers(1, 90), st.integers(1, 8))
def test_growing_delays_trip_in_the_first_interval_or_never(
    delay: int, longest: int, steps: int, interval: int, burst: int
) -> None:
    found = policy(delay, interval, burst, steps, max(delay, longest))
    assert found.never_trips is not trips(found)


def test_delays_grow_as_systemd_254_lets_them() -> None:
    found = policy(1.0, 10.0, 5, steps=2, longest=100.0)
    assert [found.next_delay(number) for number in (1, 2, 3, 4, 9)] == [1.0, 10.0, 100.0, 100.0, 100.0]


@pytest.mark.parametrize(
    ("service", "never"),
    [
        ("Restart=always\nRestartSec=2001ms", True),
        ("Restart=always\nRestartSec=2", False),
        ("Restart=always\nRestartSec=5\nStartLimitBurst=2", False),
        ("Restart=always\nRestartSec=5\nStartLimitIntervalSec=1h", True),
        ("Restart=always\nRestartSec=5\nStartLimitInterval=1h", False),
        ("Restart=always\nRestartSec=5\nStartLimitInterval=1h\nStartLimitInterval=", False),
        ("Restart=always\nRestartSec=5\nRestartSec=soon", True),
        ("Restart=always\nRestart=never\nRestartSec=5", True),
        ("Restart=no\nRestartSec=5", False),
        ("Restart=always\nRestartSec=infinity", False),
    ],
)
def test_effective_settings(tmp_path: Path, service: str, never: bool) -> None:
    unit = tmp_path / "one.service"
    unit.write_text(f"[Service]\nExecStart=/bin/true\n{service}\n")
    robot = Robot(discover([str(unit)]))
    assert robot.units.restart(robot.units.services[0]).never_trips is never
