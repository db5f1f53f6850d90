"""CycloneDDS and Fast DDS configurations, and the discovery that follows from them."""

from __future__ import annotations

from bringup_lint.model.cyclonedds import Configuration

__all__ = [
    "Configuration",
]
