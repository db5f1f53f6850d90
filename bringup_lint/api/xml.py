"""XML documents."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.model.xml import Element
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Element",
]
