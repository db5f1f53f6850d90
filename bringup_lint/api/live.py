"""The running graph compared with the files."""

from __future__ import annotations

from bringup_lint.graph.observed.observed import Observed
from bringup_lint.model.observed import RunningNode
from bringup_lint.model.observed import RunningUnit

__all__ = [
    "Observed",
    "RunningNode",
    "RunningUnit",
]
