"""What is said about a fleet: one module an output format, each with ``render(report)``, which gives the
text in pieces, because that of a big fleet does not fit into memory."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module

from bringup_lint.report.fleet.model import FleetReport

__all__ = ["FORMATS", "FleetReport", "render"]

FORMATS = ("text", "concise", "json", "sarif", "html")


def render(output_format: str, report: FleetReport) -> Iterator[str]:
    """The report in one of ``FORMATS``, ending in a newline unless it is empty."""
    pieces: Iterator[str] = import_module(f"bringup_lint.report.fleet.{output_format}").render(report)
    return pieces
