"""Limits that keep the evaluation of hostile or enormous launch files short."""

from __future__ import annotations

from bringup_lint.model.launch_values import SIZE
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import bounded
from bringup_lint.source import Span

TEXT = 4_000_000
"""Code points of a launch file."""
STEPS = 400_000
"""Statements and expressions evaluated in one file."""
CALLS = 24
"""Nested calls of the file's own functions."""
ITEMS = 10_000
"""Items of one list, values of one dictionary, actions of one description."""
LENGTH = 100_000
"""Code points of one computed string."""
GUARDS = 40
"""Conditions on one action that the file's own code adds."""


class Exhausted(Exception):
    """The file needs more steps than it is worth."""


def concat(parts: list[Value], span: Span) -> Value:
    """Text in a row; nested rows are made flat, and a row of one is that one."""
    flat: list[Value] = []
    for part in parts:
        if isinstance(part, Concat):
            flat.extend(part.parts)
        else:
            flat.append(part)
    if len(flat) == 1:
        return flat[0]
    if len(flat) > SIZE:
        return Unknown("too large", span)
    return bounded(Concat(tuple(flat), span))
