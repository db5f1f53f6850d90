"""The words of the node sources that rules use: ``from bringup_lint.api import nodes``."""

from __future__ import annotations

from bringup_lint.graph.nodes.commands import moves
from bringup_lint.graph.nodes.edits import import_edits
from bringup_lint.graph.nodes.stopping import doubles
from bringup_lint.graph.nodes.stopping import starved
from bringup_lint.graph.nodes.stopping import too_late
from bringup_lint.graph.nodes.stopping import uncaught

__all__ = ["doubles", "import_edits", "lowered", "moves", "starved", "too_late", "uncaught"]


def lowered(purpose: str, severity: str) -> str:
    """The severity of a finding in code that is only an example."""
    return "info" if purpose else severity
