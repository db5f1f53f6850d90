"""The restart arithmetic: whether a crash loop ever reaches the start limit.

Per the systemd source (``src/basic/ratelimit.c``): the limit is hit by the (burst + 1)-th start that
happens within the interval, so exactly when the first ``burst`` delays and the times to fail add up to no
more than the interval.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.systemd.manager import manager_setting
from bringup_lint.graph.systemd.settings import Setting
from bringup_lint.graph.systemd.settings import count
from bringup_lint.graph.systemd.settings import one_of
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.parsers.systemd_values import parse_timespan
from bringup_lint.source import Located
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import Any
from bringup_lint.type_names import TypeVar

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.daemons import Daemon

Value = TypeVar("Value")

DEFAULT_INTERVAL = 10.0
DEFAULT_BURST = 5
DEFAULT_DELAY = 0.1
"""systemd-system.conf(5): DefaultStartLimitIntervalSec=, DefaultStartLimitBurst=, DefaultRestartSec=."""

RESTARTS = frozenset("no on-success on-failure on-abnormal on-watchdog on-abort always".split())
BURSTS_COUNTED = 10_000
"""Delays that are added up one by one; a larger burst is extrapolated."""


_NOT_OF_ONESHOT = ("always", "on-success")
"""What systemd refuses for Type=oneshot (service.c, ``service_verify()``)."""


@dataclass(frozen=True)
class RestartPolicy:
    """What happens when the service ends. Times are in seconds."""

    restart: str | None
    """The effective Restart=, ``no`` when unset; None when it is not known."""
    restart_at: Located | None
    delay: float
    delay_at: Located | None
    steps: int
    """RestartSteps= of systemd 254: restarts until the delay has grown to ``longest``; 0 keeps it."""
    longest: float
    """The delay that restarts end up with."""
    interval: float
    interval_at: Located | None
    burst: int
    burst_at: Located | None
    misplaced: tuple[Located, ...] = ()
    """StartLimitIntervalSec= in [Service], where systemd ignores it."""
    known: bool = True
    """False when a template's placeholder hides one of the values; the numbers then are the defaults."""
    refused: bool = False
    """systemd refuses the unit for its Restart=, so that nothing ever restarts."""

    @property
    def where(self) -> Located:
        """The Restart= of a service that has one, as every service that restarts has."""
        if self.restart_at is None:
            raise LookupError("Restart= is not set")
        return self.restart_at

    @property
    def restarts(self) -> bool:
        return self.restart not in ("no", None) and self.delay != math.inf and not self.refused

    @property
    def limited(self) -> bool:
        """Whether there is a start limit at all: an interval or burst of 0 switches it off."""
        return self.known and self.interval > 0 and self.burst > 0

    @property
    def own_limit(self) -> bool:
        """Whether the unit sets a start limit of its own, rather than none, an empty one or one that is disabled."""
        return bool(self.interval_at or self.burst_at) and self.limited

    def next_delay(self, restart: int) -> float:
        """The delay before the n-th restart, counted from 1 (``service_restart_usec_next()`` of systemd 254)."""
        if restart <= 1 or not self.steps or not self.delay or math.isinf(self.longest) or self.longest <= self.delay:
            return self.delay
        if restart > self.steps:
            return self.longest
        factor: float = (self.longest / self.delay) ** ((restart - 1) / self.steps)
        return self.delay * factor

    def loop(self, fail: float = 0.0) -> float:
        """Seconds from the first start to the one that would trip the limit, when every start fails after ``fail``."""
        counted = min(self.burst, BURSTS_COUNTED)
        total = sum(self.next_delay(number) for number in range(1, counted + 1))
        return total + (self.burst - counted) * self.longest + self.burst * fail

    @property
    def never_trips(self) -> bool:
        """Whether even a service that fails at once is restarted forever."""
        return self.known and self.restarts and (not self.limited or self.loop() > self.interval)

    @property
    def leaves_no_time(self) -> bool:
        """The limit trips only in theory: the delays alone fill the interval, and every start takes some time."""
        return self.known and self.restarts and self.limited and self.loop() == self.interval


def restart_policy(unit: Unit, systemd: int, system_conf: Callable[[], list[Daemon]]) -> RestartPolicy:
    """The effective policy of a service: [Service] spellings that still count, and the manager's defaults."""

    def effective(own: Setting[Value], default: str, read: Callable[[str], Value | None], otherwise: Value) -> Value:
        if own.value is not None:
            return own.value
        configured = manager_setting(system_conf(), default, read)
        return configured[1] if configured else otherwise

    restart = unit.setting(one_of(RESTARTS), "Restart").otherwise("no")
    delay = unit.seconds("RestartSec")
    interval = unit.setting_of(
        parse_timespan,
        ("StartLimitIntervalSec", "Unit"),
        ("StartLimitInterval", "Unit"),
        ("StartLimitInterval", "Service"),
    )
    burst = unit.setting_of(count, ("StartLimitBurst", "Unit"), ("StartLimitBurst", "Service"))
    first = effective(delay, "DefaultRestartSec", parse_timespan, DEFAULT_DELAY)
    steps, longest = unit.setting(count, "RestartSteps"), unit.seconds("RestartMaxDelaySec")
    grows = systemd >= 254 and bool(steps) and longest.value is not None and 0 < first < longest.value < math.inf
    settings: list[Setting[Any]] = [restart, delay, interval, burst]
    if systemd >= 254:
        settings += [steps, longest]
    return RestartPolicy(
        restart.value,
        restart.at,
        first,
        delay.at,
        (steps.value or 0) if grows else 0,
        longest.value if grows and longest.value is not None else first,
        effective(interval, "DefaultStartLimitIntervalSec", parse_timespan, DEFAULT_INTERVAL),
        interval.at,
        effective(burst, "DefaultStartLimitBurst", count, DEFAULT_BURST),
        burst.at,
        tuple(unit.values("StartLimitIntervalSec", "Service")),
        known=not any(each.unknown for each in settings),
        refused=unit.get("Type") == "oneshot" and restart.value in _NOT_OF_ONESHOT,
    )
