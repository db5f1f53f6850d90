"""Dockerfiles: stages, and what runs in them."""

from __future__ import annotations

from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.dockerfile import runs_as_root
from bringup_lint.parsers.dockerfile import commands_of

__all__ = [
    "Stage",
    "commands_of",
    "runs_as_root",
]
