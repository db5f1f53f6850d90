"""The edits that give an element or attribute of a DDS file another name."""

from __future__ import annotations

from functools import lru_cache

from bringup_lint.parsers.xml import parse
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span


def renamed(name: Located, new: str) -> list[tuple[Span, str]]:
    """The edits that rename an element or attribute, the end tag included."""
    edits = [(name.span, new)]
    text = name.span.source.text
    before = text[name.span.start - 1 : name.span.start]
    if before == "<":
        end = _ends(name.span.source).get(name.span.start, 0)
        closing = end - len(name) - 1
        if end and text[closing - 2 : end] == f"</{name}>":
            edits.append((Span(name.span.source, closing, closing + len(name)), new))
    return edits


@lru_cache(maxsize=1)
def _ends(source: Source) -> dict[int, int]:
    """Where the name of an element starts -> where the element ends."""
    return {each.name.span.start: each.span.end for each in parse(source).elements}
