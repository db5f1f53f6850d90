"""A C++ source together with its header."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.source import Source


def with_header(nodes: Nodes, source: Source) -> str:
    """The text of a file and of those beside it and in the package that are called the same."""
    others = (each for each in nodes.named_alike(source) if each is not source)
    return "\n".join([source.text, *(each.text for each in others)])
