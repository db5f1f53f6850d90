"""The words of the topic layer that rules use: ``from bringup_lint.api import topics``."""

from __future__ import annotations

__all__ = [name for name in dir() if not name.startswith("_") and name != "annotations"]
