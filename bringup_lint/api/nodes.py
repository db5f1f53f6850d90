"""The sources of nodes: callbacks, shutdown, safe states."""

from __future__ import annotations

import re

from bringup_lint.graph.nodes.edits import import_edits
from bringup_lint.graph.nodes.edits import swap
from bringup_lint.graph.nodes.edits import tried_shutdown
from bringup_lint.graph.nodes.questions.blocking import awaits_asyncio
from bringup_lint.graph.nodes.questions.blocking import blocking
from bringup_lint.graph.nodes.questions.blocking import deadlocks
from bringup_lint.graph.nodes.questions.blocking import waits
from bringup_lint.graph.nodes.questions.motion import moves
from bringup_lint.graph.nodes.questions.safe_state import commands
from bringup_lint.graph.nodes.questions.safe_state import fed_without_condition
from bringup_lint.graph.nodes.questions.safe_state import has_safe_state
from bringup_lint.graph.nodes.questions.safe_state import is_watched_relay
from bringup_lint.graph.nodes.questions.safe_state import relays
from bringup_lint.graph.nodes.questions.safe_state import silenced
from bringup_lint.graph.nodes.questions.safe_state import uncovered_sigterm
from bringup_lint.graph.nodes.questions.stopping import doubles
from bringup_lint.graph.nodes.questions.stopping import starved
from bringup_lint.graph.nodes.questions.stopping import too_late
from bringup_lint.graph.nodes.questions.stopping import uncaught
from bringup_lint.graph.nodes.questions.undefined_names import dict_ranges
from bringup_lint.graph.nodes.questions.undefined_names import range_text
from bringup_lint.graph.nodes.questions.undefined_names import undefined

__all__ = [
    "awaits_asyncio",
    "blocking",
    "commands",
    "deadlocks",
    "dict_ranges",
    "doubles",
    "fed_without_condition",
    "has_safe_state",
    "import_edits",
    "is_watched_relay",
    "lowered",
    "moves",
    "range_text",
    "relays",
    "silenced",
    "starved",
    "swap",
    "too_late",
    "tried_shutdown",
    "uncaught",
    "uncovered_sigterm",
    "undefined",
    "valid_node_name",
    "waits",
]

_NODE_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,254}\Z")


def valid_node_name(name: str) -> bool:
    """Whether rcl takes a node name (rmw, validate_node_name.c)."""
    return bool(_NODE_NAME.match(name))


def lowered(purpose: str, severity: str) -> str:
    """The severity of a finding in code that is only an example."""
    return "info" if purpose else severity
