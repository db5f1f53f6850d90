"""Whether a robot has what a rule needs to find anything."""

from __future__ import annotations

from collections.abc import Iterable

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import Any

if TYPE_CHECKING:
    from bringup_lint.robot import Robot
    from bringup_lint.rule_index.needs import Atom
    from bringup_lint.rule_index.needs import Path

KINDS: dict[tuple[str, ...], tuple[str, ...]] = {
    ("compose", "files"): ("compose",),
    ("compose", "services"): ("compose",),
    ("compose", "whole_services"): ("compose",),
    ("installations",): ("shell-script", "dockerfile"),
    ("jails",): ("fail2ban-jail",),
    ("launch", "entries"): LAUNCH,
    ("launch", "expansions"): LAUNCH,
    ("launch", "judged"): LAUNCH,
    ("launch", "nodes"): LAUNCH,
    ("scripts", "run"): ("shell-script",),
    ("scripts", "written"): ("shell-script",),
    ("sysctl", "unknown"): ("sysctl",),
}
"""The lists that are empty in a tree without certain kinds of file, so that their layers need not be loaded."""


def is_met(needs: Iterable[Iterable[Atom]], robot: Robot) -> bool:
    """Whether one of the alternatives is there as a whole. Raises what the layers raise that are asked."""
    return any(all(_is_there(atom, robot) for atom in alternative) for alternative in needs)


def _is_there(atom: Atom, robot: Robot) -> bool:
    known = robot.answers
    if atom not in known:
        known[atom] = _answer(atom, robot)
    return known[atom]


def _answer(atom: Atom, robot: Robot) -> bool:
    what, of = atom
    if what == "key":
        return of in robot.units.keys
    if what in ("type", "manager"):
        return any(getattr(unit, what) == of for unit in robot.units.all)
    value = _value(of, robot)
    return any(True for _ in value) if what == "some" else bool(value)


def _value(path: Path, robot: Robot) -> Any:
    kinds = KINDS.get(tuple(step if isinstance(step, str) else step[0] for step in path[:2]))
    if kinds is not None and not robot.of_kind(*kinds):
        return ()
    value: Any = robot
    for step in path:
        if value is None:
            return ()
        value = getattr(value, step) if isinstance(step, str) else getattr(value, step[0])(*step[1:])
    return () if value is None else value
