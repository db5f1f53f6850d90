"""Units: settings and their spelling, directives, the sandbox and the file system of a service, edits of unit files."""

from __future__ import annotations

from bringup_lint.facts.systemd import directives
from bringup_lint.graph.systemd.capabilities import file_capabilities
from bringup_lint.graph.systemd.filesystem import forgotten
from bringup_lint.graph.systemd.filesystem import is_made
from bringup_lint.graph.systemd.filesystem import is_there
from bringup_lint.graph.systemd.limits import granted_limits
from bringup_lint.graph.systemd.memory import memory
from bringup_lint.graph.systemd.sandbox import paths
from bringup_lint.graph.systemd.sandbox import sandbox
from bringup_lint.graph.systemd.settings import duration
from bringup_lint.graph.systemd.settings import flag
from bringup_lint.graph.systemd.unit_edits import delete_lines
from bringup_lint.graph.systemd.unit_edits import lift_comment
from bringup_lint.graph.systemd.unit_edits import move_lines

__all__ = [
    "delete_lines",
    "directives",
    "duration",
    "file_capabilities",
    "flag",
    "forgotten",
    "granted_limits",
    "is_made",
    "is_there",
    "lift_comment",
    "memory",
    "move_lines",
    "paths",
    "sandbox",
]
