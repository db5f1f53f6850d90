"""XML documents."""

from __future__ import annotations

from bringup_lint.model.xml import Element

__all__ = [
    "Element",
]
