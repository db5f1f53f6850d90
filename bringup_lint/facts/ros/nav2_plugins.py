"""The lists of plugins that the servers of Navigation2 read, with their defaults."""

from __future__ import annotations

_COSTMAP = {"plugins": ("static_layer", "obstacle_layer", "inflation_layer"), "filters": ()}
LISTS: dict[str, dict[str, tuple[str, ...]]] = {
    "controller_server": {
        "controller_plugins": ("FollowPath",),
        "goal_checker_plugins": ("goal_checker",),
        "progress_checker_plugins": ("progress_checker",),
    },
    "planner_server": {"planner_plugins": ("GridBased",)},
    "smoother_server": {"smoother_plugins": ("simple_smoother",)},
    "behavior_server": {
        "behavior_plugins": ("spin", "backup", "drive_on_heading", "wait"),
    },
    "local_costmap": _COSTMAP,
    "global_costmap": _COSTMAP,
}
"""Node -> the parameters that name plugins -> the names whose classes the server knows by itself, when the list is just
these, in this order. Source: navigation2, Humble to Kilted: controller_server.cpp, planner_server.cpp,
nav2_smoother.cpp, behavior_server.cpp, costmap_2d_ros.cpp."""

DEFAULTS: dict[str, frozenset[str]] = {
    **{name: frozenset(default) for lists in LISTS.values() for name, default in lists.items()},
    "path_handler_plugins": frozenset(("PathHandler",)),
}
"""List -> the plugins that its server loads where nothing gives it the list. Source: also navigation2, main:
nav2_controller/parameter_handler.hpp."""
