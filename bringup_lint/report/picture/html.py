"""The picture as a page that needs nothing else."""

from __future__ import annotations

from typing import Any

from bringup_lint.report.html import page


def render(document: dict[str, Any]) -> str:
    return page(document)
