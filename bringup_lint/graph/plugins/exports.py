"""The plugins that the packages of the tree export, by the names under which they are loaded."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.parsers.xml import parse
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Workspace

FILES = 400
"""XML files of one package that are looked at."""
_OTHERS = ("package.xml", ".launch.xml", "behavior_tree.xml")


def exports(tree: Tree, workspace: Workspace) -> dict[str, dict[str, Located]]:
    """Package -> the classes that its plugin descriptions name, each with its place. A description that the package
    does not install counts, too."""
    found: dict[str, dict[str, Located]] = {}
    for path in tree.paths:
        if not path.endswith((".xml", ".xml.in")) or path.endswith(_OTHERS):
            continue
        package = workspace.package_of(os.path.dirname(path))
        if package is None or len(found.setdefault(package.name, {})) > FILES:
            continue
        source = tree.read(path, judged=False)
        if source is not None and "base_class_type" in source.text:
            found[package.name].update(_classes(source))
    return found


def _classes(source: Source) -> Iterator[tuple[str, Located]]:
    root = parse(source).root
    if root is None:
        return
    for element in root.walk():
        name = element.get("name") or element.get("type")
        if element.local == "class" and name is not None and element.get("base_class_type") is not None:
            yield str(name), name
