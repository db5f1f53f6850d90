"""The files that a robot description includes with xacro."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from bringup_lint.graph.workspace import Place
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.workspace import Found
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.source import Source

_FOUND = regex(r"\$\(find\s+(?P<package>[\w-]+)\s*\)/(?P<rest>[^$]+)\Z")
_UNKNOWN = frozenset("$*?[")
"""Characters of names that xacro computes, or that stand for several files."""


def included(workspace: Workspace, source: Source, filename: str) -> Found | None:
    """What the ``filename`` of an ``xacro:include`` leads to; None when the tree cannot tell."""
    match = _FOUND.match(filename)
    if match is not None:
        place = Place("share", match["package"], match["rest"])
    else:
        place = Place("file", "", os.path.join(os.path.dirname(source.absolute), filename))
    return None if _UNKNOWN & set(place.path) else workspace.find(place)
