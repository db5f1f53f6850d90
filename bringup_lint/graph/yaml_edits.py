"""Edits of YAML files that keep every space and comment."""

from __future__ import annotations

from bringup_lint.model.yaml_node import Mapping
from bringup_lint.source import Span


def first_key(mapping: Mapping, text: str) -> tuple[Span, str]:
    """The edit that puts ``key: value`` first into a YAML mapping, in its own indentation or style."""
    source, at = mapping.span.source, mapping.span.start + mapping.flow
    gap = ", " if mapping.flow else "\n" + " " * (source.position(at).column - 1)
    return source.span(at, at), text + gap
