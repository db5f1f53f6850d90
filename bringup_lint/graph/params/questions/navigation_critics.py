"""Controllers of Navigation2 none of whose critics looks at obstacles."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.params.questions.navigation_blocks import NavigationProblem
from bringup_lint.graph.params.questions.navigation_blocks import by_name
from bringup_lint.graph.params.values import items

if TYPE_CHECKING:
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter

OF_DWB = frozenset(
    "BaseObstacle GoalAlign GoalDist ObstacleFootprint Oscillation PathAlign PathDist PreferForward RotateToGoal "
    "Twirling".split()
)
_OF_MPPI = frozenset(
    "Constraint Cost GoalAngle Goal Obstacles PathAlign PathAlignLegacy PathAngle PathFollow PreferForward Twirling "
    "VelocityDeadband".split()
)
"""Critics without the word at their end, in any distribution (dwb_critics, default_critics.xml; nav2_mppi_controller,
critics.xml)."""
CRITICS = {
    "dwb_core::DWBLocalPlanner": OF_DWB,
    "nav2_mppi_controller::MPPIController": frozenset(f"{each}Critic" for each in _OF_MPPI),
}
_OF_OBSTACLES = frozenset(("BaseObstacle", "ObstacleFootprint", "CostCritic", "ObstaclesCritic"))


def critics_of(named: dict[str, Parameter]) -> Iterator[tuple[str, Parameter, frozenset[str]]]:
    """The sections of a server whose controller takes critics, with their list and those that it has."""
    for name, each in named.items():
        section = name.removesuffix(".critics")
        plugin = named.get(f"{section}.primary_controller") or named.get(f"{section}.plugin")
        known = CRITICS.get(str(plugin.value.data)) if plugin is not None and section != name else None
        if known is not None and f"{section}.default_critic_namespaces" not in named:
            yield section, each, known


def plain(critic: str, known: frozenset[str]) -> str:
    """The name of a critic as the table has it: DWB adds the word at the end by itself."""
    return critic.removesuffix("Critic") if known is OF_DWB else critic


def blind_controllers(block: Block) -> Iterator[NavigationProblem]:
    """Controllers all of whose critics are known, and none of which looks at the costmap."""
    named = by_name(block)
    for section, each, known in critics_of(named):
        listed = [plain(item.text, known) for item in items(each)]
        working = [critic for critic in listed if not _is_off(named, section, critic)]
        if listed and known.issuperset(listed) and _OF_OBSTACLES.isdisjoint(working):
            yield NavigationProblem("blind", each.key.span, section, ", ".join(sorted(_OF_OBSTACLES & known)))


def _is_off(named: dict[str, Parameter], section: str, critic: str) -> bool:
    enabled = named.get(f"{section}.{critic}.enabled")
    return enabled is not None and enabled.value.data is False
