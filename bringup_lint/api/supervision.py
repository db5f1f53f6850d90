"""What services launch, and who tells systemd that they are alive."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.supervision.launched_by_unit import devices_opened_by
    from bringup_lint.graph.supervision.launched_by_unit import every_node_respawns
    from bringup_lint.graph.supervision.launched_by_unit import expansion_of
    from bringup_lint.graph.supervision.launched_processes import StopTime
    from bringup_lint.graph.supervision.launched_processes import stop_time
    from bringup_lint.graph.supervision.lifecycle import Unstarted
    from bringup_lint.graph.supervision.lifecycle import unstarted
    from bringup_lint.graph.supervision.notify import CERTAIN
    from bringup_lint.graph.supervision.notify import Silence
    from bringup_lint.graph.supervision.notify import SilentService
    from bringup_lint.graph.supervision.overlap import Overlap
    from bringup_lint.graph.supervision.overlap import Umbrella
    from bringup_lint.graph.supervision.overlap import UnitLaunch
    from bringup_lint.graph.supervision.overlap import launches_of
    from bringup_lint.graph.supervision.overlap import overlaps
    from bringup_lint.graph.supervision.overlap import umbrellas
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "CERTAIN",
    "Overlap",
    "Silence",
    "SilentService",
    "StopTime",
    "Umbrella",
    "UnitLaunch",
    "Unstarted",
    "devices_opened_by",
    "every_node_respawns",
    "expansion_of",
    "launches_of",
    "overlaps",
    "stop_time",
    "umbrellas",
    "unstarted",
]
