"""What services launch: the processes and devices of the launch files that a unit runs."""

from __future__ import annotations

from bringup_lint.graph.launch.of_units import all_respawn
from bringup_lint.graph.launch.of_units import devices_of
from bringup_lint.graph.launch.of_units import launched
from bringup_lint.graph.launch.supervision import stop_time

__all__ = [
    "all_respawn",
    "devices_of",
    "launched",
    "stop_time",
]
