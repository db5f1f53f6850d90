"""Names that a Python file imports from another file of the tree, which has none of these."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.tree_imports import Taken
from bringup_lint.graph.nodes.sources.tree_imports import bindings
from bringup_lint.graph.nodes.sources.tree_imports import may_fail
from bringup_lint.graph.nodes.sources.tree_imports import taken
from bringup_lint.model.node_source import NodeSource
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import nearest_of_few

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_OF_MODULES = frozenset(("__file__", "__name__", "__doc__", "__path__", "__spec__", "__loader__", "__package__"))


class MissingName(NamedTuple):
    file: NodeSource
    alias: ast.alias
    defined: NodeSource
    """The file that is imported."""
    like: str | None
    """What it defines under nearly the same name."""
    function: str | None
    """The function that imports it; None: the file, when it is loaded."""


def missing_names(nodes: Nodes) -> Iterator[MissingName]:
    for file in nodes.robot_code:
        for each in taken(nodes, file):
            names = bindings(nodes, each.file)
            if each.alias.name in names or each.alias.name in _OF_MODULES or _is_module(nodes, each):
                continue
            if not may_fail(nodes.syntax(file), each.statement):
                near = nearest_of_few(each.alias.name, names)
                function = nodes.syntax(file).function(each.statement)
                named = function.name if function is not None else None
                yield MissingName(file, each.alias, each.file, near[0] if len(near) == 1 else None, named)


def _is_module(nodes: Nodes, each: Taken) -> bool:
    """Whether a name may be that of a module in the folder that is imported, perhaps one that a build makes."""
    folder, name = os.path.split(each.file.source.absolute)
    if name != "__init__.py":
        return False
    tree, path = nodes.files.tree, os.path.join(folder, each.alias.name)
    is_made = tree.is_ignored(path) or tree.is_ignored(f"{path}.py") or tree.exists(f"{folder}/CMakeLists.txt")
    return is_made or tree.exists(path) or each.alias.name in _stems(nodes, folder)


@memo
def _stems(nodes: Nodes, folder: str) -> frozenset[str]:
    """The names of the files of a folder without their endings."""
    return frozenset(os.path.basename(each).partition(".")[0] for each in nodes.files.tree.walked_in(folder))
