"""Secrets in clear text."""

from __future__ import annotations

from bringup_lint.graph.secrets.in_clear import Secret

__all__ = ["Secret"]
