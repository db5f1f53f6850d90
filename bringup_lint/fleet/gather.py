"""The summaries of all robots, into the store as they come."""

from __future__ import annotations

from collections.abc import Iterable

from bringup_lint.config import ConfigError
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.store import FleetRobot
from bringup_lint.fleet.store import Store
from bringup_lint.fleet.store import StoreError
from bringup_lint.fleet.store import opened
from bringup_lint.fleet.summary import Summary


def stored(members: Iterable[Member], summaries: Iterable[Summary]) -> Store:
    """``members`` are in the order of their names. Raises ConfigError when there is no room for the summaries."""
    store = opened()
    for number, each in enumerate(members):
        store.robots.append(FleetRobot(number, each.name, each.role, each.site, each.domain, each.talks, store))
    numbers = {robot.name: robot.number for robot in store.robots}
    try:
        for summary in summaries:
            store.add(numbers[summary.name], summary)
        store.index()
    except StoreError as error:
        raise ConfigError(str(error)) from error
    return store
