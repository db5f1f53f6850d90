"""What is said about a fleet: one module an output format, each with ``render(report) -> str``."""

from __future__ import annotations

from importlib import import_module

from bringup_lint.report.fleet.model import FleetReport

__all__ = ["FORMATS", "FleetReport", "render"]

FORMATS = ("text", "concise", "json", "sarif", "html")


def render(output_format: str, report: FleetReport) -> str:
    """The report in one of ``FORMATS``, ending in a newline unless it is empty."""
    text: str = import_module(f"bringup_lint.report.fleet.{output_format}").render(report)
    return text
