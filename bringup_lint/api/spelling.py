"""Misspelt words."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.spelling import Neighbours
    from bringup_lint.spelling import is_slip
    from bringup_lint.spelling import longer
    from bringup_lint.spelling import nearest
    from bringup_lint.spelling import nearest_of_few
    from bringup_lint.spelling import numbered
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Neighbours",
    "is_slip",
    "longer",
    "nearest",
    "nearest_of_few",
    "numbered",
]
