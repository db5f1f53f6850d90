"""A parameter whose value a node keeps and does not use."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span


class UnusedParameter(NamedTuple):
    source: Source
    name: Located
    variable: Located
    """``speed_`` of C++, ``self.speed`` of Python."""
    given: Span | None
    """Where a launch or parameter file of the package sets it."""
    is_logged: bool
