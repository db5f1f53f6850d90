"""What is said about a run: one module an output format, each with ``render(report) -> str``."""

from __future__ import annotations

from importlib import import_module

from bringup_lint.report.model import Notification
from bringup_lint.report.model import Part
from bringup_lint.report.model import Report
from bringup_lint.report.model import RuleDoc
from bringup_lint.report.model import Target

__all__ = ["DRAWN", "FINDINGS_ALONE", "FORMATS", "Notification", "Part", "Report", "RuleDoc", "Target", "render"]

FORMATS = ("text", "concise", "json", "sarif", "html", "github", "gitlab", "junit", "markdown", "rdjson")
FINDINGS_ALONE = ("concise", "gitlab", "rdjson")
"""The formats that have no place for anything but findings."""
DRAWN = ("html", "markdown")
"""The formats that show the picture of the bring-up."""


def render(output_format: str, report: Report) -> str:
    """The report in one of ``FORMATS``, ending in a newline unless it is empty."""
    text: str = import_module(f"bringup_lint.report.{output_format}").render(report)
    return text
