"""Files and values that a person or a tool still fills in."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.templates import final_name
    from bringup_lint.templates import has_placeholder
    from bringup_lint.templates import is_example
    from bringup_lint.templates import is_stand_in
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "final_name",
    "has_placeholder",
    "is_example",
    "is_stand_in",
]
