"""Files as nodes of the graph."""

from __future__ import annotations

from bringup_lint.graph.graph import Node
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

_OPEN = regex(r"[$%*?{}@\n]")


def file_node(kind: str, source: Source) -> Node:
    """A file of the tree."""
    return Node(kind, source.name)


def file_place(source: Source) -> Span:
    """The whole file."""
    return source.span(0, len(source.text))


def is_plain(text: str) -> bool:
    """Whether nothing is put into a name any more: no variables, specifiers, globs or placeholders."""
    return not _OPEN.search(text)
