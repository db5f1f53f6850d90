"""Parameters that a lifecycle node declares once more, in C++ and Python."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

RETAKES = regex(r"\bundeclare_parameter\b|\bParameterAlreadyDeclared", hints="Declared undeclare_parameter")
"""What gives parameters back, or takes the exception."""
GUARD = regex(r"(?i)has_parameter|declar|first|once|init|configured")
"""A condition that may know whether it is the first time."""


class DeclaredAgain(NamedTuple):
    """A parameter that each transition "configure" of a lifecycle node declares."""

    place: Span
    function: str
    """``on_configure``."""
