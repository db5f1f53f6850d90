"""Netplan: the merged plan and its interfaces."""

from __future__ import annotations

from bringup_lint.model.netplan import Address
from bringup_lint.model.netplan import Interface
from bringup_lint.model.netplan import Plan

__all__ = [
    "Address",
    "Interface",
    "Plan",
]
