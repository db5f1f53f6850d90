"""Where the launch and parameter files of a package set a parameter of its nodes."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_FILES_OF_LAUNCH = (".launch.py", ".launch.xml", ".launch.yaml", ".yaml", ".yml", ".xml")
_MOST = 200


def given_in_package(nodes: Nodes, source: Source, name: str) -> Span | None:
    """Where a file of the package sets a parameter of this name."""
    owner = nodes.launch.workspace.owner(source)
    if owner is None:
        return None
    word = re.escape(name)
    key = re.compile(
        rf"(?:^[ \t]{{1,40}}(?P<yaml>{word})[ \t]{{0,4}}:|[\"'](?P<python>{word})[\"'][ \t]{{0,4}}:"
        rf"|<param\s{{1,40}}name=[\"'](?P<xml>{word})[\"'])",
        re.M,
    )
    paths = [path for path in nodes.files.tree.walked_below(owner.folder) if path.endswith(_FILES_OF_LAUNCH)]
    for path in paths[:_MOST]:
        file = nodes.files.tree.read(path, judged=False)
        found = key.search(file.text) if file is not None and name in file.text else None
        if file is not None and found is not None:
            return Span(file, *found.span(found.lastgroup or 0))
    return None
