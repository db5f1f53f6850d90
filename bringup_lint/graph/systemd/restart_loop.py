"""What becomes of a service that fails again and again."""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple

from bringup_lint.graph.systemd.restart import RestartPolicy
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units

SLOW = 60.0
"""Seconds between restarts from which a loop is a deliberate, harmless retry."""
FAST = 1.0
"""Seconds between restarts below which an endless loop loads the computer and the journal."""
FAILING_LAUNCH = 1.0
"""Seconds that ros2 launch needs at least to start and fail."""


class Outcome(Enum):
    NO_LIMIT = "the start limit is switched off"
    NEVER_TRIPS = "the restarts take longer than the interval of the start limit"
    NO_TIME_LEFT = "the restarts fill the interval of the start limit"
    GIVES_UP = "the default limit trips soon, and the service stays down"
    SLOW_FAILURE = "the default limit trips only when every start fails at once"


class Loop(NamedTuple):
    outcome: Outcome
    is_unwanted: bool
    """The unit counts on an end, or the loop does harm by itself; else somebody may want it."""


def restart_loop(unit: Unit, policy: RestartPolicy, units: Units) -> Loop | None:
    """What is wrong with a crash loop of the service; None when nothing is, or when it is not known.

    A limit in the wrong section explains everything: the line itself is the finding then.
    """
    if not unit.complete or not policy.known or not policy.restarts or policy.misplaced:
        return None
    if policy.never_trips:
        return _endless(policy)
    if policy.leaves_no_time:
        return Loop(Outcome.NO_TIME_LEFT, False)
    if policy.interval_at or policy.burst_at:
        return None
    is_ros = unit in units.ros
    if policy.restart == "always" and policy.delay < 1 and (is_ros or policy.delay):
        return Loop(Outcome.GIVES_UP, is_ros)
    launches = any(unit is launching for launching, _ in units.launch)
    slow = launches and policy.loop(FAILING_LAUNCH) > policy.interval
    return Loop(Outcome.SLOW_FAILURE, False) if slow else None


def _endless(policy: RestartPolicy) -> Loop | None:
    if policy.steps and policy.longest >= SLOW:
        return None
    if not policy.limited:
        return Loop(Outcome.NO_LIMIT, policy.longest < FAST)
    is_unwanted = policy.own_limit or policy.restart == "always"
    return Loop(Outcome.NEVER_TRIPS, is_unwanted and policy.longest < SLOW)
