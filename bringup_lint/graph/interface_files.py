"""Where messages, services and actions are defined."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree

KINDS = ("msg", "srv", "action")
NAMED = regex(r"(?:^|/)(?P<name>[A-Z][A-Za-z0-9]*)\.(?P<kind>msg|srv|action|idl)\Z")
_SUFFIXES = (".msg", ".srv", ".action", ".idl")


def interface_files(tree: Tree, folder: str) -> dict[tuple[str, str], str]:
    """Kind and name -> the file that defines it, of all below an absolute folder."""
    found = {}
    for path in tree.walked_below(folder):
        full = os.path.abspath(path) if path.endswith(_SUFFIXES) else ""
        match = NAMED.search(full)
        if match is not None:
            kind = match["kind"] if match["kind"] != "idl" else _kind_of_idl(full[len(folder) + 1 :])
            found[kind, match["name"]] = full
    return found


def _kind_of_idl(path: str) -> str:
    """That of the folder that it lies in."""
    return next((each for each in path.split("/") if each in KINDS), "msg")
