"""The running graph compared with the files."""

from __future__ import annotations

from bringup_lint.graph.observed.observed import Observed

__all__ = [
    "Observed",
]
