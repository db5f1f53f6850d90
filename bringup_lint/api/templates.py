"""Files and values that a person or a tool still fills in."""

from __future__ import annotations

from bringup_lint.templates import is_example
from bringup_lint.templates import is_stand_in

__all__ = [
    "is_example",
    "is_stand_in",
]
