"""udev rules: tokens, matches and links."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.udev.conditions import Condition
    from bringup_lint.graph.udev.order import TooEarly
    from bringup_lint.graph.udev.rule import Link
    from bringup_lint.graph.udev.rule import UdevRule
    from bringup_lint.model.udev import Rule
    from bringup_lint.model.udev import RulesFile
    from bringup_lint.model.udev import Token
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Condition",
    "Link",
    "Rule",
    "RulesFile",
    "Token",
    "TooEarly",
    "UdevRule",
]
