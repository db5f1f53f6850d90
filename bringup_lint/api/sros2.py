"""Keystores, policies, governance and permissions documents."""

from __future__ import annotations

from bringup_lint.model.sros2_policy import PolicyEnclave
from bringup_lint.model.sros2_policy import Right

__all__ = [
    "PolicyEnclave",
    "Right",
]
