"""Netplan: the merged plan and its interfaces, and what its grammar knows about a key."""

from __future__ import annotations

from bringup_lint.graph.netplan.subnets import Subnets
from bringup_lint.model.netplan import Address
from bringup_lint.model.netplan import Interface
from bringup_lint.model.netplan import Plan
from bringup_lint.model.netplan import PlanCode
from bringup_lint.parsers.netplan_schema import home_of

__all__ = [
    "Address",
    "Interface",
    "Plan",
    "PlanCode",
    "Subnets",
    "home_of",
]
