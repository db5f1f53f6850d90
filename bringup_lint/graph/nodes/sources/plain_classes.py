"""Classes of the tree that build on nothing and that nothing builds on, so that all of their attributes are known."""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import kept
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_self
from bringup_lint.model.python import last_name

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_PLAIN_BASES = frozenset({"object", "ABC"})


@kept
def plain_classes(nodes: Nodes) -> PlainClasses:
    return PlainClasses(nodes)


class PlainClasses:
    """What all files of the tree say of classes and of the attributes of objects."""

    def __init__(self, nodes: Nodes) -> None:
        self.foreign: set[str] = set()
        """Attributes that code sets on something else than ``self``."""
        self._bases: set[str] = set()
        self._made: set[str] = set()
        for file in nodes.robot_code:
            for node in file.nodes:
                if isinstance(node, ast.Attribute) and not isinstance(node.ctx, ast.Load):
                    if not is_self(node.value):
                        self.foreign.add(node.attr)
                elif isinstance(node, ast.ClassDef):
                    self._bases.update(map(last_name, node.bases))
                elif isinstance(node, ast.Call):
                    self._made.add(called_name(node))

    def knows(self, node: ast.ClassDef) -> bool:
        is_open = node.decorator_list or node.keywords or not all(map(_is_plain, node.bases))
        return not is_open and node.name in self._made and node.name not in self._bases


def _is_plain(base: ast.expr) -> bool:
    is_of_abc = isinstance(base, ast.Attribute) and isinstance(base.value, ast.Name) and base.value.id == "abc"
    return (is_of_abc or isinstance(base, ast.Name)) and last_name(base) in _PLAIN_BASES
