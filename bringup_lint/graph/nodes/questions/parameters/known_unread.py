"""Parameters of which a page of their package says that nothing reads them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.memo import memo
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.workspace import Package

_PAGE = regex(r"(?i)\.(?:md|rst)$")
_NAMED = regex(r"`{1,2}([\w./~]{1,80})`")
_UNREAD = regex(
    r"(?i)\b(?:not|never|no longer|isn't)\b[^.|\n]{0,40}\b(?:used|read|implemented|supported)\b|\bunused\b"
    r"|\bdeprecated\b|\breserved for\b|\bhas no effect\b|\bplaceholder\b"
)
_PAGES = 20
"""Pages of a package that are read."""
_SIZE = 200_000
"""How much is read of a page."""


def is_known_unread(nodes: Nodes, source: Source, name: Located) -> bool:
    """Whether a page of the package, in a line that names the parameter, or a comment beside it says that it is not
    used."""
    owner = nodes.launch.workspace.owner(source)
    if owner is not None and str(name) in _unread(nodes, owner):
        return True
    _, _, remark = name.span.source.line_text(name.line).partition("//" if not source.name.endswith(".py") else "#")
    return _UNREAD.search(remark) is not None


@memo
def _unread(nodes: Nodes, owner: Package) -> frozenset[str]:
    """What the pages of a package name in lines which say that it is not read."""
    tree = nodes.files.tree
    pages = [path for path in tree.walked_below(owner.folder) if _PAGE.search(path)][:_PAGES]
    lines = (line for path in pages for line in tree.head(path, _SIZE).splitlines())
    return frozenset(name for line in lines if _UNREAD.search(line) for name in _NAMED.findall(line)[:1])
