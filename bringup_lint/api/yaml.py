"""Edits of YAML files."""

from __future__ import annotations

from bringup_lint.graph.yaml_edits import first_key

__all__ = [
    "first_key",
]
