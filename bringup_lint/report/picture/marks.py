"""How drawings tell layers and severities apart: by colour, and by a sign for those who do not see the colour."""

from __future__ import annotations

from bringup_lint.plural import counted

SIGNS = {"error": "✖", "warning": "▲", "info": "●"}
STROKES = {"error": "#b3261e", "warning": "#b26a00", "info": "#0072b2", "": "#5f6368"}
FILLS = {
    "boot": "#dceaf7",
    "environment": "#e6f2dc",
    "launch": "#fdf0d2",
    "parameters": "#f3e6f5",
    "dds": "#d9f0ee",
    "security": "#f8dfdc",
    "network": "#e3e4f6",
    "devices": "#efe7dc",
    "topics": "#fbe3ef",
}
TEXT = "#1f1f1f"

ALWAYS_WHOLE = frozenset({"user", "program", "topic", "process", "enclave"})
"""Kinds that are no files, so that nothing is missing when no file defines them."""


def marked(label: str, severity: str, count: int) -> list[str]:
    """The lines of a node: its label, and the sign of its worst finding with their number."""
    return [label, f"{SIGNS[severity]} {counted(count, 'finding')}"] if severity else [label]
