"""Compose files: services and what they share."""

from __future__ import annotations

from bringup_lint.model.compose import Service

__all__ = [
    "Service",
]
