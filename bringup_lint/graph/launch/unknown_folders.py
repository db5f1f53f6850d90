"""Paths in packages of which only the folders between are not known: their file is missing whatever these are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.workspace import Found
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Value
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.workspace import Workspace

_FILE = regex(r"[\w-]+(?:\.[\w-]+)+")


def last_name(value: Value) -> str:
    """The name of the file at the end of a path that is known there; empty when it is not."""
    if not isinstance(value, (PathJoin, Concat)):
        return ""
    last = value.parts[-1]
    if not isinstance(last, Literal) or not isinstance(last.value, str):
        return ""
    _, slash, name = last.value.rpartition("/")
    return name if (slash or isinstance(value, PathJoin)) and _FILE.fullmatch(name) else ""


def missing_everywhere(value: Value, workspace: Workspace) -> Found | None:
    """A file in the share folder of a package when the tree has none of its name; None where it cannot tell."""
    name = last_name(value)
    where = place(value.parts[0]) if name and isinstance(value, (PathJoin, Concat)) else None
    package = workspace.packages.get(where.package) if where is not None and where.base == "share" else None
    if package is None or not package.complete or next(workspace.tree.named(name), None) is not None:
        return None
    return None if package.makes_files else Found(None, None, package)
