"""Containers of C++ that nothing of a package fills."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.threads import package_sources
from bringup_lint.model.cpp_text import plain_of

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.source import Source

_FILLS = (
    r"\b{0}\s{{0,4}}(?:\.|->)\s{{0,4}}(?:push|emplace|insert|assign|resize|swap|append|splice|merge)"
    r"|\b{0}\s{{0,4}}(?:=(?!=)|\[|\{{|\()|[(,&*]\s{{0,4}}{0}\s{{0,4}}[,)]"
)


def is_never_filled(nodes: Nodes, source: Source, name: str) -> bool:
    """Whether all sources of the package are known, and none puts anything into a container or hands it out."""
    fills = re.compile(_FILLS.format(re.escape(name)))
    return all(
        each is not None and not (name in each.text and fills.search(plain_of(each)))
        for each in package_sources(nodes, source)
    )
