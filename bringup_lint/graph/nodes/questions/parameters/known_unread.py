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
    r"(?i)[\s*_]{0,8}(?:(?:is|it|this|the|parameter|value|but|and|an?|just|only|currently|now|still|so far|at present)"
    r"\s{1,4}){0,6}"
    r"(?:(?:not|never|no longer|isn't)\s{1,4}(?:(?:currently|yet|actually|really)\s{1,4}){0,2}"
    r"(?:used|read|implemented|supported)"
    r"(?:\s{1,4}(?:by|any ?more|yet|at all|at present|at the moment|now|currently|in this version)\b[^,]{0,80})?"
    r"[\s*_]{0,8}\Z"
    r"|(?:unused|deprecated|reserved for|has no effect|placeholder)\b)"
)
"""What is said of the parameter itself: a clause without another subject."""
_CONDITION = regex(r"(?i)\b(?:if|when|whenever|unless|while|until|except|in case|above|below)\b")
_SENTENCE = regex(r"[.;:|()]|\s[-–—]\s")
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
    return _says_unread(remark)


@memo
def _unread(nodes: Nodes, owner: Package) -> frozenset[str]:
    """What the pages of a package name in lines which say that it is not read."""
    tree = nodes.files.tree
    pages = [path for path in tree.walked_below(owner.folder) if _PAGE.search(path)][:_PAGES]
    lines = (line for path in pages for line in tree.head(path, _SIZE).splitlines())
    named = (each for line in lines if (each := _NAMED.search(line)) is not None)
    return frozenset(each[1] for each in named if _says_unread(each.string[each.end() :]))


def _says_unread(text: str) -> bool:
    """Whether a sentence without a condition says that what was named before is not used."""
    sentences = (each for each in _SENTENCE.split(text) if not _CONDITION.search(each))
    return any(_UNREAD.match(clause) for each in sentences for clause in each.split(","))
