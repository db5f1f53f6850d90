"""The running graph compared with the files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.observed.expected import Entry
    from bringup_lint.graph.observed.observed import Observed
    from bringup_lint.model.observed import RunningNode
    from bringup_lint.model.observed import RunningUnit
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Entry",
    "Observed",
    "RunningNode",
    "RunningUnit",
]
