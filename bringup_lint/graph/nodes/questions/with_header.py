"""A C++ source together with its header."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.source import Source


def with_header(nodes: Nodes, source: Source) -> str:
    """The text of a file and of those beside it and in the package that are called the same."""
    stem = os.path.basename(source.name).partition(".")[0]
    owner = nodes.launch.workspace.owner(source)
    texts = [source.text]
    for each in nodes.files.of_kind("cpp-node"):
        if each is not source and os.path.basename(each.name).partition(".")[0] == stem:
            if nodes.launch.workspace.owner(each) is owner:
                texts.append(each.text)
    return "\n".join(texts)
