"""The functions and aliases of all scripts of a tree."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.memo import kept
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_DEFINED = regex(
    r"(?:^|[;&|{(\"'])[ \t]*(?:function[ \t]+(?P<spoken>[\w.:+-]+)|(?P<plain>[\w.:+-]+)[ \t]*\([ \t]*\)"
    r"|alias[ \t]+(?:-\w+[ \t]+)?(?P<alias>[\w.:+-]+)=)",
    0,
    "function ( alias",
)
_READ_BY_LINE = ("shell-script", "dockerfile")


@kept
def functions(files: Files) -> frozenset[str]:
    """Their names, wherever a line or a text in quotes begins with a definition."""
    texts = (source.text for kind in _READ_BY_LINE for source in files.of_kind(kind))
    lines = (line for text in texts for line in text.splitlines())
    return frozenset(match[match.lastgroup or 0] for line in lines for match in _DEFINED.finditer(line))
