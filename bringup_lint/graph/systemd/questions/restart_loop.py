"""What becomes of a service that fails again and again."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from collections.abc import Iterator
from enum import Enum

from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.systemd.questions.docker_clients import docker_starts
from bringup_lint.graph.systemd.questions.unstartable import OF_NO_PACKAGE
from bringup_lint.graph.systemd.restart import DEFAULT_BURST
from bringup_lint.graph.systemd.restart import RestartPolicy
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span

SLOW = 60.0
"""Seconds between restarts from which a loop is a deliberate, harmless retry."""
FAST = 1.0
"""Seconds between restarts below which an endless loop loads the computer and the journal."""
FAILING_LAUNCH = 1.0
"""Seconds that ros2 launch needs at least to start and fail."""

_RELAY = regex(
    r"(?:micro_?ros_agent|MicroXRCEAgent|rosbridge_\w+|foxglove_bridge|rmw_zenohd|zenohd|zenoh-bridge\S*|domain_bridge"
    r"|ptp4l|phc2sys|ser2net|autossh|frpc|cloudflared|mavproxy|mavlink-router\w*)(?:[.-]|$|_launch)",
    re.I,
    "ros bridge xrce zenoh ptp4l phc2sys ser2net autossh frpc cloudflared mav",
)
"""Programs that do nothing but connect to something, and that end when it is not there."""


class Outcome(Enum):
    NO_LIMIT = "the start limit is switched off"
    NEVER_TRIPS = "the restarts take longer than the interval of the start limit"
    NO_TIME_LEFT = "the restarts fill the interval of the start limit"
    GIVES_UP = "the default limit trips soon, and the service stays down"
    EITHER = "the default limit trips or not, and without a pause there is harm in both"
    SLOW_FAILURE = "the default limit trips only when every start fails at once"


class Loop(NamedTuple):
    outcome: Outcome
    is_unwanted: bool
    """The unit counts on an end, or the loop does harm by itself; else somebody may want it."""


class CrashLoop(NamedTuple):
    """A service, and what becomes of it when it fails again and again."""

    unit: Unit
    policy: RestartPolicy
    loop: Loop

    @property
    def counts_on_default(self) -> bool:
        """Whether it counts on the default limit or the default delay: one cause for all such services of a robot."""
        by_default = (Outcome.NEVER_TRIPS, Outcome.GIVES_UP, Outcome.EITHER)
        return self.loop.outcome in by_default and not self.policy.own_limit

    @property
    def cause(self) -> Located | None:
        """The setting that switches the limit off, else the one that enables the restarts."""
        policy = self.policy
        if policy.never_trips and policy.interval_at and not policy.interval:
            return policy.interval_at
        if policy.never_trips and policy.burst_at and not policy.burst:
            return policy.burst_at
        return policy.restart_at

    @property
    def place(self) -> Located | Span:
        return self.cause or self.unit.where

    @property
    def spare(self) -> float:
        """Seconds that each start may take to fail so that the limit still trips."""
        return (self.policy.interval - self.policy.loop()) / self.policy.burst


def crash_loops(
    units: Units, purpose: Callable[[Located | Span], Purpose]
) -> Iterator[tuple[CrashLoop, list[CrashLoop]]]:
    """The crash loops that need attention; those that count on the default limit as one for each purpose, with the
    others of them."""
    by_default: dict[tuple[Purpose, Loop], list[CrashLoop]] = {}
    found: list[list[CrashLoop]] = []
    for unit in units.services:
        policy = units.restart(unit)
        loop = restart_loop(unit, policy, units)
        if loop is None:
            continue
        crash = CrashLoop(unit, policy, loop)
        key = (purpose(crash.place), loop)
        group = by_default.setdefault(key, []) if crash.counts_on_default else []
        group.append(crash)
        if len(group) == 1:
            found.append(group)
    return ((first, others) for first, *others in found)


class Limit(NamedTuple):
    """A start limit that trips even when each start takes ten seconds to fail."""

    burst: int
    interval: int
    """Seconds, a multiple of 30."""

    def edits(self, unit: Unit, policy: RestartPolicy) -> Iterator[tuple[Located | Span, str]]:
        """Change the settings of the unit, and add those that it does not have."""
        missing = []
        for at, key, value in (
            (policy.interval_at, "StartLimitIntervalSec", self.interval),
            (policy.burst_at, "StartLimitBurst", self.burst),
        ):
            if at is None:
                missing.append(f"{key}={value}")
            elif str(value) != at:
                yield at, str(value)
        if missing:
            yield unit.new_line("Unit", "\n".join(missing))


def sufficient_limit(policy: RestartPolicy) -> Limit:
    burst = policy.burst or DEFAULT_BURST
    return Limit(burst, math.ceil(burst * (policy.longest + 10) / 30) * 30)


def restart_loop(unit: Unit, policy: RestartPolicy, units: Units) -> Loop | None:
    """What is wrong with a crash loop of the service; None when nothing is, or when it is not known.

    A limit in the wrong section explains everything: the line itself is the finding then.
    """
    if not unit.complete or not policy.known or not policy.restarts or policy.misplaced:
        return None
    if policy.never_trips:
        return _endless(unit, policy, units)
    if policy.leaves_no_time:
        return Loop(Outcome.NO_TIME_LEFT, False)
    if policy.interval_at or policy.burst_at:
        return None
    containers = [start for process in units.started(unit) for start in docker_starts(process)]
    of_robot = unit in units.ros or bool(containers)
    relays = only_connects(unit, units)
    if (policy.restart == "always" or relays) and policy.delay < 1 and (of_robot or policy.delay):
        fails_late = bool(units.launches(unit)) or any(each.compose and not each.detached for each in containers)
        return Loop(Outcome.EITHER if fails_late else Outcome.GIVES_UP, of_robot or relays)
    slow = unit in units.launching and policy.loop(FAILING_LAUNCH) > policy.interval
    return Loop(Outcome.SLOW_FAILURE, False) if slow else None


def only_connects(unit: Unit, units: Units) -> bool:
    """Whether a service only relays for a board, a browser or a clock that may come at any time: it retries until
    then."""
    for process in units.started(unit):
        commands = [process.argv, *(step.command.words for step in process.steps)]
        programs = [words[0] for words in map(unwrapped, commands) if words]
        programs += [ros.where for _, ros in process.ros]
        if any(_RELAY.match(program.rpartition("/")[2]) for program in programs):
            return True
    return False


def _endless(unit: Unit, policy: RestartPolicy, units: Units) -> Loop | None:
    if policy.steps and policy.longest >= SLOW:
        return None
    if not policy.limited:
        return Loop(Outcome.NO_LIMIT, policy.longest < FAST)
    if policy.own_limit:
        return Loop(Outcome.NEVER_TRIPS, policy.longest < SLOW)
    retries = policy.restart != "always" or policy.longest >= SLOW or only_connects(unit, units)
    return Loop(Outcome.NEVER_TRIPS, not retries and (_is_of_robot(unit, units) or _acts_on_end(unit, units)))


def _is_of_robot(unit: Unit, units: Units) -> bool:
    """Whether a unit starts ROS, or a program that no package of the distribution brings."""
    words = (word for process in units.started(unit) for word in process.argv)
    return unit in units.ros or any(map(OF_NO_PACKAGE.match, words))


def _acts_on_end(unit: Unit, units: Units) -> bool:
    """Whether the unit says what is to happen once it counts as failed for good, which it never does."""
    actions = (unit.get(key, "Unit") for key in ("FailureAction", "StartLimitAction"))
    handled = unit.has("OnFailure", "Unit") and not units.fails_each_time(unit)
    return handled or any(action not in (None, "none") for action in actions)
