"""Dockerfiles."""

from __future__ import annotations

from bringup_lint.model.dockerfile import runs_as_root
from bringup_lint.parsers.dockerfile import commands_of

__all__ = [
    "commands_of",
    "runs_as_root",
]
