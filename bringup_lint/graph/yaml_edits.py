"""Edits of YAML files that keep every space and comment."""

from __future__ import annotations

from bringup_lint.model.yaml_node import Mapping
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

_LINE_END = regex(r"\r?\n")
_NEXT_LINE = regex(r"\s*\n(?P<margin> *)\S")


def first_key(mapping: Mapping, text: str) -> tuple[Span, str]:
    """The edit that puts ``key: value`` first into a YAML mapping, in its own indentation or style."""
    source, at = mapping.span.source, mapping.span.start + mapping.flow
    gap = ", " if mapping.flow else "\n" + " " * (source.position(at).column - 1)
    return source.span(at, at), text + gap


def last_key(mapping: Mapping, text: str) -> tuple[Span, str]:
    """The edit that puts ``key: value`` last into a YAML mapping; first where its end is not clear."""
    source, span = mapping.span.source, mapping.span
    last = mapping.pairs[-1][1].span if mapping.pairs else span
    margin = source.position(span.start).column - 1
    at = _end_of_line(source, last.end)
    is_inside = span.start < last.start and last.end <= span.end
    if mapping.flow or not is_inside or last.text.endswith("\n") or _margin_below(source, at) >= margin:
        return first_key(mapping, text)
    return source.span(at, at), "\n" + " " * margin + text


def _end_of_line(source: Source, at: int) -> int:
    found = _LINE_END.search(source.text, at)
    return found.start() if found is not None else len(source.text)


def _margin_below(source: Source, at: int) -> int:
    """The blanks at the start of the next line that holds something; -1 at the end of the file."""
    found = _NEXT_LINE.match(source.text, at)
    return len(found["margin"]) if found is not None else -1
