"""``CYCLONEDDS_URI``: files and XML documents in a comma-separated list, each overriding those before it.

A part that begins with ``<`` is XML, which ends where its root element ends; any other part ends at the next
comma and is a path, with or without ``file://`` (``ddsi_config_init``).
"""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.source import Located
from bringup_lint.source import Source

_BETWEEN = " \t\n\v\f\r,"


class Part(NamedTuple):
    text: Located
    """A path without ``file://``, or an XML document."""
    inline: bool


def split_uri(value: Located) -> Iterator[Part]:
    """The configurations that a value of the variable names, in the order in which they are read."""
    at = 0
    while True:
        at += len(value) - at - len(value[at:].lstrip(_BETWEEN))
        if at >= len(value):
            return
        if value[at] == "<":
            end = at + _document_length(value[at:])
            yield Part(value.part(at, end), True)
        else:
            comma = value.find(",", at)
            end = len(value) if comma == -1 else comma
            path = value.part(at, end)
            yield Part(path.part(7, len(path)) if path.startswith("file://") else path, False)
        at = end


def _document_length(text: str) -> int:
    """Where the first document of a text ends; an unfinished one takes all."""
    document = parse(Source("", text))
    root = document.root
    if root is None or root.tag.end == len(text):
        return len(text)
    unfinished = any(problem.code in ("unclosed-element", "unclosed-markup") for problem in document.problems)
    return len(text) if unfinished else root.span.end
