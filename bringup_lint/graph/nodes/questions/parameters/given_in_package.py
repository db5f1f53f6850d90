"""Where the launch and parameter files of a package set a parameter of its nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.memo import memo
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_FILES_OF_LAUNCH = (".launch.py", ".launch.xml", ".launch.yaml", ".yaml", ".yml", ".xml")
_MOST = 200
_SET = regex(
    r"(?m)^[ \t]{1,40}(?P<yaml>[\w./-]+)[ \t]{0,4}:|[\"'](?P<python>[\w./-]+)[\"'][ \t]{0,4}:"
    r"|<param\s{1,40}name=[\"'](?P<xml>[\w./-]+)[\"']"
)


def given_in_package(nodes: Nodes, source: Source, name: str) -> Span | None:
    """Where a file of the package sets a parameter of this name."""
    owner = nodes.launch.workspace.owner(source)
    return None if owner is None else _given(nodes, owner.folder).get(name)


@memo
def _given(nodes: Nodes, folder: str) -> dict[str, Span]:
    """The first place of each name that the files of a package set."""
    found: dict[str, Span] = {}
    paths = [path for path in nodes.files.tree.walked_below(folder) if path.endswith(_FILES_OF_LAUNCH)]
    for file in filter(None, (nodes.files.tree.read(path, judged=False) for path in paths[:_MOST])):
        for match in _SET.finditer(file.text):
            group = match.lastgroup or 0
            found.setdefault(match[group], file.span(*match.span(group)))
    return found
