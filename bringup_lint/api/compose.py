"""Compose files: services and what they share."""

from __future__ import annotations

from bringup_lint.model.compose import Device
from bringup_lint.model.compose import Service
from bringup_lint.model.compose import reach
from bringup_lint.parsers.compose_schema import homes_of

__all__ = [
    "Device",
    "Service",
    "homes_of",
    "reach",
]
