"""A robot description with everything that it includes with xacro."""

from __future__ import annotations

import os
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.workspace import Place
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Found
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.model.xml import Element
    from bringup_lint.source import Source

USED = regex(r"\$\(arg\s+(\w+)\s*\)")
"""An argument of a description in a path or value."""
_FILES = 60
"""Descriptions that one includes."""
_FOUND = regex(r"\$\(find\s+(?P<package>[\w-]+)\s*\)/(?P<rest>[^$]+)\Z")
_UNKNOWN = frozenset("$*?[")
"""Characters of names that xacro computes, or that stand for several files."""


@dataclass(eq=False)
class Description:
    files: list[tuple[Source, Element]] = field(default_factory=list)
    """Each file once, with its root."""
    defaults: dict[str, str] = field(default_factory=dict)
    """Argument -> the default that is read first."""
    missing: list[str] = field(default_factory=list)
    """The ``filename`` of what is included and not in the tree."""
    complete: bool = True
    """Every file was read."""


def description(workspace: Workspace, tree: Tree, source: Source, *, surely: bool) -> Description:
    """What a description is made of; ``surely``: without what conditions and macros include or declare."""
    todo, seen = [source], {source.name}
    whole = Description()
    while todo:
        each = todo.pop()
        root = parse(each).root if not each.template else None
        if root is None or len(seen) > _FILES:
            whole.complete = False
            continue
        whole.files.append((each, root))
        for file in _included(workspace, tree, each, root.children if surely else root.walk(), whole):
            if file.name not in seen:
                seen.add(file.name)
                todo.append(file)
    return whole


def _included(
    workspace: Workspace, tree: Tree, source: Source, elements: Iterable[Element], whole: Description
) -> Iterator[Source]:
    """The files that elements include; keeps the defaults that they declare."""
    for element in elements:
        if element.name == "xacro:arg":
            whole.defaults.setdefault(str(element.get("name")), str(element.get("default") or ""))
        elif element.name == "xacro:include":
            filename = _filled(str(element.get("filename") or ""), whole.defaults)
            found = included(workspace, source, filename)
            file = tree.at(found.file) if found is not None and found.file is not None else None
            if file is None:
                whole.missing.append(filename)
            else:
                yield file


def _filled(filename: str, defaults: dict[str, str]) -> str:
    """The name of a file with the defaults of arguments: what other values choose declares the same arguments."""
    return USED.sub(lambda used: defaults.get(used[1], used[0]), filename)


def included(workspace: Workspace, source: Source, filename: str) -> Found | None:
    """What the ``filename`` of an ``xacro:include`` leads to; None when the tree cannot tell."""
    match = _FOUND.match(filename)
    if match is not None:
        place = Place("share", match["package"], match["rest"])
    else:
        place = Place("file", "", os.path.join(os.path.dirname(source.absolute), filename))
    return None if _UNKNOWN & set(place.path) else workspace.find(place)


def is_unconditional(element: Element) -> bool:
    """Whether no condition, macro or call of xacro decides whether an element is in the description."""
    return not any(each.name.startswith("xacro:") for each in element.ancestors)
