"""What readers of tables say about a file, for rules that turn it into findings."""

from __future__ import annotations

from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.schema.names import suggestions

__all__ = ["Code", "Item", "Remark", "suggestions"]
