"""Topics: endpoints, velocity commands, misspelt names."""

from __future__ import annotations

from bringup_lint.graph.topics.commands import has_stop_hardware
from bringup_lint.graph.topics.commands import is_gate
from bringup_lint.graph.topics.commands import is_stop
from bringup_lint.graph.topics.commands import is_velocity
from bringup_lint.graph.topics.commands import rivals
from bringup_lint.graph.topics.commands import ungated
from bringup_lint.graph.topics.names import refusal
from bringup_lint.graph.topics.names import tail
from bringup_lint.graph.topics.namespaces import shared_by_namespaces
from bringup_lint.graph.topics.publishing import published_at_start
from bringup_lint.graph.topics.unconnected import corrected
from bringup_lint.graph.topics.unconnected import misspelt
from bringup_lint.graph.topics.unconnected import unserved

__all__ = [
    "corrected",
    "has_stop_hardware",
    "is_gate",
    "is_stop",
    "is_velocity",
    "misspelt",
    "published_at_start",
    "refusal",
    "rivals",
    "shared_by_namespaces",
    "tail",
    "ungated",
    "unserved",
]
