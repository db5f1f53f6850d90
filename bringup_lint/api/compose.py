"""Compose files: services and what they share."""

from __future__ import annotations

from bringup_lint.model.compose import Device
from bringup_lint.model.compose import Service
from bringup_lint.model.compose import reach

__all__ = [
    "Device",
    "Service",
    "reach",
]
