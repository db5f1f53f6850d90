"""What services launch: the processes and devices of the launch files that a unit runs."""

from __future__ import annotations

from bringup_lint.graph.supervision.launched_by_unit import all_respawn
from bringup_lint.graph.supervision.launched_by_unit import devices_of
from bringup_lint.graph.supervision.launched_by_unit import launched
from bringup_lint.graph.supervision.launched_processes import stop_time

__all__ = [
    "all_respawn",
    "devices_of",
    "launched",
    "stop_time",
]
