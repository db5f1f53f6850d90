"""Options of a controller of Navigation2 that exclude each other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.params.questions.navigation_blocks import NavigationProblem
from bringup_lint.graph.params.questions.navigation_blocks import by_name

if TYPE_CHECKING:
    from bringup_lint.model.params import Block

_PURSUIT = "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
_DISTRIBUTIONS = ("galactic", "humble")
"""Where the controller gives reversing up for turning on the spot, which is its default
(regulated_pure_pursuit_controller.cpp); newer ones do so in a change of the parameters alone."""
_REVERSES, _TURNS = "allow_reversing", "use_rotate_to_heading"


def lost_reversals(server: Block, distribution: str | None) -> Iterator[NavigationProblem]:
    """Controllers that are to drive backwards and to turn on the spot first."""
    if distribution not in _DISTRIBUTIONS:
        return
    named = by_name(server)
    for name, each in named.items():
        section, _, last = name.rpartition(".")
        if last != _REVERSES or each.value.data is not True:
            continue
        plugin, turns = named.get(f"{section}.plugin"), named.get(f"{section}.{_TURNS}")
        if plugin is not None and plugin.value.data == _PURSUIT and (turns is None or turns.value.data is True):
            detail = f"{_TURNS} is true" + (" by default" if turns is None else "")
            yield NavigationProblem("reversing", each.span, name, detail, turns.span if turns is not None else None)
