"""The restart arithmetic: whether a crash loop ever reaches the start limit.

Per the systemd source (``src/basic/ratelimit.c``): the limit is hit by the (burst + 1)-th start that happens within the interval,
so exactly when burst × (delay + time to fail) ≤ interval.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from bringup_lint.graph.unit import Unit
from bringup_lint.parsers.systemd_values import parse_bool
from bringup_lint.parsers.systemd_values import parse_integer
from bringup_lint.parsers.systemd_values import parse_timespan
from bringup_lint.source import Located

DEFAULT_INTERVAL = 10.0
DEFAULT_BURST = 5
DEFAULT_DELAY = 0.1
"""systemd-system.conf(5): DefaultStartLimitIntervalSec=, DefaultStartLimitBurst=, DefaultRestartSec=."""


@dataclass(frozen=True)
class RestartPolicy:
    """What happens when the service ends. Times are in seconds; None stands for a value that could not be read."""

    restart: str
    """The effective Restart=, ``no`` when unset."""
    restart_at: Located | None
    delay: float | None
    delay_at: Located | None
    interval: float | None
    interval_at: Located | None
    burst: int | None
    burst_at: Located | None

    @property
    def restarts(self) -> bool:
        return self.restart != "no"

    @property
    def known(self) -> bool:
        return None not in (self.delay, self.interval, self.burst)

    @property
    def limited(self) -> bool:
        """Whether there is a start limit at all: an interval or burst of 0 switches it off."""
        return self.known and self.interval > 0 and self.burst > 0

    @property
    def loop(self) -> float:
        """Seconds that ``burst`` restarts take when every start fails at once."""
        return self.burst * self.delay

    @property
    def never_trips(self) -> bool:
        """Whether even a service that fails at once is restarted for ever."""
        return self.restarts and self.known and (not self.limited or self.loop > self.interval)


def restart_policy(unit: Unit, systemd: int) -> RestartPolicy:
    """The effective policy of a service, [Service] spellings that still count included."""
    restart = unit.get("Restart", "Service")
    delay_at = unit.get("RestartSec", "Service")
    delay = DEFAULT_DELAY if delay_at is None else parse_timespan(delay_at)
    if systemd >= 254 and delay is not None:
        delay = _mean_delay(unit, delay)
    interval_at = _last(unit, ("StartLimitIntervalSec", "Unit"), ("StartLimitInterval", "Unit"), ("StartLimitInterval", "Service"))
    burst_at = _last(unit, ("StartLimitBurst", "Unit"), ("StartLimitBurst", "Service"))
    return RestartPolicy(
        str(restart or "no"),
        restart,
        delay,
        delay_at,
        DEFAULT_INTERVAL if interval_at is None else parse_timespan(interval_at),
        interval_at,
        DEFAULT_BURST if burst_at is None else parse_integer(burst_at),
        burst_at,
    )


def _last(unit: Unit, *settings: tuple[str, str]) -> Located | None:
    """The assignment that comes last among several spellings of one setting."""
    found = None
    for file in unit.files:
        for assignment in file.assignments:
            if (str(assignment.key), str(assignment.section)) in settings:
                found = assignment.value or None
    return found


def _mean_delay(unit: Unit, delay: float) -> float | None:
    """With RestartSteps= and RestartMaxDelaySec= the delay grows from one restart to the next; the mean of the first burst."""
    steps_at, most_at = unit.get("RestartSteps", "Service"), unit.get("RestartMaxDelaySec", "Service")
    if steps_at is None or most_at is None:
        return delay
    steps, most = parse_integer(steps_at), parse_timespan(most_at)
    if not steps or most is None or math.isinf(most) or delay <= 0 or most <= delay:
        return delay if steps == 0 else None
    count = DEFAULT_BURST
    return sum(delay * (most / delay) ** (min(n, steps) / steps) for n in range(count)) / count


def truth(value: Located | None, default: bool) -> bool | None:
    """A boolean setting; the default when it is unset, None when the value is none."""
    return default if value is None else parse_bool(value)
