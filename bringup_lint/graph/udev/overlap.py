"""Whether two udev rules can fire for one device."""

from __future__ import annotations

from collections.abc import Collection

from bringup_lint.graph.udev.conditions import Condition
from bringup_lint.graph.udev.conditions import contradict
from bringup_lint.graph.udev.conditions import implies
from bringup_lint.graph.udev.rule import UdevRule


def may_both_fire(one: UdevRule, other: UdevRule, assigned: Collection[str] = ()) -> bool:
    """False when the matches exclude each other; ``assigned`` names the properties that rules set."""
    if one.subsystems and other.subsystems and not one.subsystems & other.subsystems:
        return False
    left = [condition for condition in one.conditions.positive if _is_constant(condition, assigned)]
    right = [condition for condition in other.conditions.positive if _is_constant(condition, assigned)]
    if any(contradict(a, b) for a in left for b in right):
        return False
    return not (_jumped_over(one, other) or _jumped_over(other, one))


def _is_constant(condition: Condition, assigned: Collection[str]) -> bool:
    return condition.key != "ENV" or condition.attribute not in assigned


def _jumped_over(one: UdevRule, other: UdevRule) -> bool:
    """Whether a device of ``one`` certainly takes a jump over ``other``."""
    if one.file is not other.file:
        return False
    return any(
        all(implies(one.conditions.positive, condition) for condition in jump) for jump in other.conditions.jumps
    )


def fires_whenever(one: UdevRule, other: UdevRule) -> bool:
    """Whether ``one`` fires for every device for which ``other`` fires, at whatever event."""
    wanted = [condition for condition in one.conditions.positive if condition.key != "ACTION"]
    return all(implies(other.conditions.positive, condition) for condition in wanted)
