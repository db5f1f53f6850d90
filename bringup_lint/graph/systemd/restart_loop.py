"""What becomes of a service that fails again and again."""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple

from bringup_lint.graph.systemd.restart import RestartPolicy
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units

SLOW = 60.0
"""Seconds between restarts from which a loop is a deliberate, harmless retry."""
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
    intended: bool
    """Somebody counts on an end, or ROS depends on it."""


def restart_loop(unit: Unit, policy: RestartPolicy, units: Units) -> Loop | None:
    """What is wrong with a crash loop of the service; None when nothing is, or when it is not known."""
    if not unit.complete or not policy.known or not policy.restarts:
        return None
    is_ros = unit in units.ros
    if policy.never_trips:
        if policy.steps and policy.longest >= SLOW:
            return None
        wanted = policy.restart == "always" or is_ros or policy.own_limit or unit.has("OnFailure")
        outcome = Outcome.NEVER_TRIPS if policy.limited else Outcome.NO_LIMIT
        return Loop(outcome, policy.longest < SLOW and wanted)
    if policy.leaves_no_time:
        return Loop(Outcome.NO_TIME_LEFT, False)
    if policy.interval_at or policy.burst_at or policy.misplaced:
        return None
    if policy.restart == "always" and policy.delay < 1 and (is_ros or policy.delay):
        return Loop(Outcome.GIVES_UP, is_ros)
    launches = any(unit is launching for launching, _ in units.launch)
    slow = launches and policy.loop(FAILING_LAUNCH) > policy.interval
    return Loop(Outcome.SLOW_FAILURE, False) if slow else None
