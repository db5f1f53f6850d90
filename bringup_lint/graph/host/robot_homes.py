"""The folders below ``/home`` that the files of a tree say a robot has."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from typing import TYPE_CHECKING

from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Workspace

_ADDING = ("useradd", "adduser")
_SETTING = regex(r"^[ \t]*(?:ARG|ENV)[ \t]+USER(?:NAME)?[= ][ \t]*[\"']?(?P<name>[A-Za-z_][\w.-]*)", re.M)
_WORD = regex(r"[A-Za-z_][\w.-]*")
_VISITED = regex(r"\bcd[ \t]+(?P<path>/home/[\w.-]+/[\w.-]+)")
_MOST = 200_000
"""Characters of a page that are looked at."""


def own_folders(files: Files, users: Iterable[str], workspace: Workspace) -> frozenset[str]:
    """The folders of homes that a robot has because its tree says so: the homes of users that an image makes and of
    those that units run as, and the workspaces in which the page of the tree, not of a package, has people work."""
    images = [source.text for source in files.of_kind("dockerfile") if source.judged]
    lines = (line for text in images for line in text.splitlines() if any(word in line for word in _ADDING))
    names = {*users, *(word for line in lines for word in _WORD.findall(line))}
    names |= {match["name"] for text in images if "/home/" in text for match in _SETTING.finditer(text)}
    pages = (
        path
        for path in files.tree.named("README.md")
        if workspace.package_of(os.path.dirname(os.path.abspath(path))) is None
    )
    visited = (match["path"] for path in pages for match in _VISITED.finditer(files.tree.head(path, _MOST)))
    return frozenset((*(f"/home/{name}" for name in names), *visited))
