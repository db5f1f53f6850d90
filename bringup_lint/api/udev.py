"""udev rules: tokens, matches and links."""

from __future__ import annotations

from bringup_lint.graph.udev.conditions import Condition
from bringup_lint.graph.udev.order import TooEarly
from bringup_lint.graph.udev.rule import Link
from bringup_lint.graph.udev.rule import UdevRule
from bringup_lint.model.udev import RulesFile
from bringup_lint.model.udev import Token

__all__ = [
    "Condition",
    "Link",
    "RulesFile",
    "Token",
    "TooEarly",
    "UdevRule",
]
