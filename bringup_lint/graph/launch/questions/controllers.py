"""Which launch files start the controllers of ros2_control, and which the manager that loads them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import kept

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started

MANAGER, SPAWNER = "ros2_control_node", "spawner"


def is_manager(node: Started) -> bool:
    return literal_text(node.executable) == MANAGER


def starts_controllers(expansion: Expansion) -> bool:
    return any(literal_text(each.executable) == SPAWNER for each in expansion.nodes)


@kept
def has_controllers_apart(launch: Launch) -> bool:
    """Whether a launch file starts controllers of a manager that another one starts."""
    return any(starts_controllers(each) and not any(map(is_manager, each.nodes)) for each in launch.entries)
