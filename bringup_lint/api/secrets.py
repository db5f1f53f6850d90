"""Secrets in clear text."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.secrets.in_clear import Secret
    from bringup_lint.graph.secrets.in_clear import assigned_secret
else:
    __getattr__ = on_demand(globals())

__all__ = ["Secret", "assigned_secret"]
