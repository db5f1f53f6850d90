"""The restart arithmetic: whether a crash loop ever reaches the start limit.

Per the systemd source (``src/basic/ratelimit.c``): the limit is hit by the (burst + 1)-th start that
happens within the interval, so exactly when the first ``burst`` delays and the times to fail add up to no
more than the interval.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from bringup_lint.graph.systemd.manager import manager_setting
from bringup_lint.graph.systemd.settings import Setting
from bringup_lint.graph.systemd.settings import seconds
from bringup_lint.graph.systemd.settings import setting
from bringup_lint.graph.systemd.settings import word
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.parsers.systemd_values import parse_integer
from bringup_lint.parsers.systemd_values import parse_timespan
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

DEFAULT_INTERVAL = 10.0
DEFAULT_BURST = 5
DEFAULT_DELAY = 0.1
"""systemd-system.conf(5): DefaultStartLimitIntervalSec=, DefaultStartLimitBurst=, DefaultRestartSec=."""

RESTARTS = frozenset("no on-success on-failure on-abnormal on-watchdog on-abort always".split())
BURSTS_COUNTED = 10_000
"""Delays that are added up one by one; a larger burst is extrapolated."""


@dataclass(frozen=True)
class RestartPolicy:
    """What happens when the service ends. Times are in seconds; None stands for a value that is not known."""

    restart: str | None
    """The effective Restart=, ``no`` when unset."""
    restart_at: Located | None
    delay: float | None
    delay_at: Located | None
    steps: int
    """RestartSteps= of systemd 254: restarts until the delay has grown to ``longest``; 0 keeps it."""
    longest: float | None
    """The delay that restarts end up with."""
    interval: float | None
    interval_at: Located | None
    burst: int | None
    burst_at: Located | None
    misplaced: tuple[Located, ...] = ()
    """StartLimitIntervalSec= in [Service], where systemd ignores it."""

    @property
    def restarts(self) -> bool:
        return self.restart not in ("no", None) and self.delay != math.inf

    @property
    def known(self) -> bool:
        return None not in (self.restart, self.delay, self.longest, self.interval, self.burst)

    @property
    def limited(self) -> bool:
        """Whether there is a start limit at all: an interval or burst of 0 switches it off."""
        return self.known and self.interval > 0 and self.burst > 0

    @property
    def own_limit(self) -> bool:
        """Whether the unit sets a start limit of its own, at the right place or not, rather than none or an empty
        one."""
        return bool(self.misplaced or self.interval_at or self.burst_at) and (self.limited or bool(self.misplaced))

    def next_delay(self, restart: int) -> float:
        """The delay before the n-th restart, counted from 1 (``service_restart_usec_next()`` of systemd 254)."""
        if restart <= 1 or not self.steps or not self.delay or math.isinf(self.longest) or self.longest <= self.delay:
            return self.delay
        if restart > self.steps:
            return self.longest
        return self.delay * (self.longest / self.delay) ** ((restart - 1) / self.steps)

    def loop(self, fail: float = 0.0) -> float:
        """Seconds from the first start to the one that would trip the limit, when every start fails after ``fail``."""
        counted = min(self.burst, BURSTS_COUNTED)
        total = sum(self.next_delay(number) for number in range(1, counted + 1))
        return total + (self.burst - counted) * self.longest + self.burst * fail

    @property
    def never_trips(self) -> bool:
        """Whether even a service that fails at once is restarted for ever."""
        return self.known and self.restarts and (not self.limited or self.loop() > self.interval)

    @property
    def leaves_no_time(self) -> bool:
        """The limit trips only in theory: the delays alone fill the interval, and every start takes some time."""
        return self.known and self.restarts and self.limited and self.loop() == self.interval


def restart_policy(unit: Unit, robot: Robot) -> RestartPolicy:
    """The effective policy of a service: [Service] spellings that still count, and the manager's defaults."""
    restart = word(unit, "Restart", RESTARTS)
    delay = seconds(unit, "RestartSec")
    interval = setting(
        unit,
        parse_timespan,
        ("StartLimitIntervalSec", "Unit"),
        ("StartLimitInterval", "Unit"),
        ("StartLimitInterval", "Service"),
    )
    burst = setting(unit, _count, ("StartLimitBurst", "Unit"), ("StartLimitBurst", "Service"))
    seconds_to_restart = _value(robot, delay, "DefaultRestartSec", parse_timespan, DEFAULT_DELAY)
    steps, longest = _growth(unit, robot, seconds_to_restart)
    return RestartPolicy(
        "no" if restart.at is None else restart.value,
        restart.at,
        seconds_to_restart,
        delay.at,
        steps,
        longest,
        _value(robot, interval, "DefaultStartLimitIntervalSec", parse_timespan, DEFAULT_INTERVAL),
        interval.at,
        _value(robot, burst, "DefaultStartLimitBurst", _count, DEFAULT_BURST),
        burst.at,
        tuple(value for value in unit.values("StartLimitIntervalSec", "Service")),
    )


def _count(text: str) -> int | None:
    value = parse_integer(text)
    return None if value is None or value < 0 else value


def _value(robot: Robot, own: Setting, default: str, read, otherwise):
    if own.at is not None:
        return own.value
    configured = manager_setting(robot, default, read)
    return configured[1] if configured else otherwise


def _growth(unit: Unit, robot: Robot, delay: float | None) -> tuple[int, float | None]:
    """RestartSteps= and the delay that restarts end up with."""
    if robot.target.systemd < 254:
        return 0, delay
    steps, longest = setting(unit, _count, ("RestartSteps", "Service")), seconds(unit, "RestartMaxDelaySec")
    if steps.unknown or longest.unknown:
        return 0, None
    if not steps.value or longest.value is None or delay is None or math.isinf(longest.value):
        return 0, delay
    return (steps.value, longest.value) if 0 < delay < longest.value else (0, delay)
