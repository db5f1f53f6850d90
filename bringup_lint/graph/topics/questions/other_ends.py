"""Where a node uses a name or profile that another module defines."""

from __future__ import annotations

from bringup_lint.finding import Related
from bringup_lint.finding import span_of
from bringup_lint.source import Located
from bringup_lint.source import Span

_PYTHON = ("", "python-node")
"""Kinds of the modules from which nodes import."""


def used_at(place: Located | Span, where: Span) -> list[Related]:
    """The call of a node, where what it is handed lies in another module; else nothing."""
    source = span_of(place).source
    is_imported = source is not where.source and source.kind in _PYTHON and where.source.kind == "python-node"
    return [Related(where, "used here")] if is_imported else []
