"""Memory limits of a unit, comparable with each other. systemd.resource-control(5)."""

from __future__ import annotations

import math

from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values import parse_share
from bringup_lint.parsers.systemd_values import parse_size
from bringup_lint.source import Located


class Memory(NamedTuple):
    at: Located
    amount: float
    """``math.inf`` for no limit."""
    unit: str
    """``B``, or ``%`` of the memory of the machine."""


def memory(unit: Unit, key: str) -> Memory | None:
    """A memory limit; None when it is unset, switched off or not known."""
    found = unit.setting(_amount, key, section=unit.section)
    if found.at is None or found.value is None:
        return None
    amount, measure = found.value
    return None if amount == math.inf else Memory(found.at, amount, measure)


def _amount(text: str) -> tuple[float, str] | None:
    if text == "infinity":
        return math.inf, "B"
    share = parse_share(text)
    if share is not None:
        return share, "%"
    size = parse_size(text)
    return (float(size), "B") if size else None
