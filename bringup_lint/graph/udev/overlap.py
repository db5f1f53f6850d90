"""Whether two udev rules can fire for one device."""

from __future__ import annotations

from collections.abc import Collection

from bringup_lint.graph.udev.conditions import Condition
from bringup_lint.graph.udev.conditions import contradict
from bringup_lint.graph.udev.conditions import implies
from bringup_lint.graph.udev.rule import UdevRule

_ONE_DEVICE = frozenset(
    {
        ("ATTRS", "serial"),
        ("KERNELS", ""),
        ("ENV", "ID_PATH"),
        ("ENV", "ID_PATH_TAG"),
        ("ENV", "ID_SERIAL"),
        ("ENV", "ID_SERIAL_SHORT"),
    }
)
"""Matches that one device of a robot fulfils: its serial number, or the port that it is plugged into."""


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


def are_nodes_of_one_camera(one: UdevRule, other: UdevRule) -> bool:
    """Whether they differ in nothing but the index of the video node, and name the one camera that has both."""
    if one.has_priority or other.has_priority or not one.is_for("video4linux"):
        return False
    left, right = _without_index(one), _without_index(other)
    named = any((key, attribute) in _ONE_DEVICE for key, attribute, *_ in left)
    return named and left == right and _indexes(one).isdisjoint(_indexes(other))


def _indexes(rule: UdevRule) -> set[str]:
    return {text for each in rule.on("ATTR", "index") if each.equal and each.is_plain for text in each.patterns}


def _without_index(rule: UdevRule) -> set[tuple[str, str, bool, tuple[str, ...]]]:
    conditions = rule.conditions.positive
    return {(each.key, each.attribute, each.equal, each.patterns) for each in conditions if not _is_index(each)}


def _is_index(condition: Condition) -> bool:
    return (condition.key, condition.attribute) == ("ATTR", "index")


def fires_whenever(one: UdevRule, other: UdevRule) -> bool:
    """Whether ``one`` fires for every device for which ``other`` fires, at whatever event."""
    wanted = [condition for condition in one.conditions.positive if condition.key != "ACTION"]
    return all(implies(other.conditions.positive, condition) for condition in wanted)
