"""The Python modules of a workspace: which file an import names, and classes that build on classes of other files."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Iterable
from typing import TYPE_CHECKING

from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.parsers.python_node import parse
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Workspace

Parsed = Callable[[Callable[[Source], NodeSource], Iterable[Source]], list[NodeSource]]

_DEPTH = 6
"""Files through which a class is followed."""
CLOSURE = 100
"""Files that one program imports."""
_GENERATED = frozenset({"msg", "srv", "action"})
"""Modules of a package that are made from its interfaces."""


class Modules:
    """``files``: the sources of nodes; ``parsed`` reads one more, noting failures."""

    def __init__(self, tree: Tree, workspace: Workspace, files: list[NodeSource], parsed: Parsed) -> None:
        self.files = files
        self._tree = tree
        self._workspace = workspace
        self._parsed = parsed
        self.by_path: dict[str, NodeSource | None] = {file.source.absolute: file for file in files}
        self.by_source = {file.source: file for file in files}
        self._modules: dict[tuple[str, str], NodeSource | None] = {}
        self._names: dict[tuple[str, NodeSource], NodeClass | None] = {}

    def link(self) -> None:
        """Give each class the one it builds on, where it is in another file of the tree."""
        for file in self.files:
            for node in file.classes:
                self._link(file, node, 0)

    def _link(self, file: NodeSource, node: NodeClass, depth: int) -> None:
        if node.is_node is not None or node.base is not None or depth > _DEPTH:
            if node.base is not None and node.is_node is None and depth <= _DEPTH:
                self._link(file, node.base, depth + 1)
                _inherit(node)
            return
        for name in node.bases:
            base = self.class_named(name, file, depth + 1)
            if base is not None and base is not node:
                node.base = base
                _inherit(node)
                return

    def class_named(self, dotted: str, file: NodeSource, depth: int = 0) -> NodeClass | None:
        """The class of nodes that a dotted name means in a file; names are followed through imports."""
        local = file.class_named(dotted)
        if local is not None or depth > _DEPTH:
            return local
        key = (dotted, file)
        if key not in self._names:
            self._names[key] = None
            self._names[key] = self._imported(dotted, file, depth)
        return self._names[key]

    def _imported(self, dotted: str, file: NodeSource, depth: int) -> NodeClass | None:
        module, _, name = dotted.rpartition(".")
        if module.strip(".") == "" and module:
            module = f"{module}."
        other = self.module(module, file) if module else None
        if other is None:
            return None
        found = other.class_named(name)
        if found is not None:
            self._link(other, found, depth + 1)
            return found
        target = other.imports.get(name)
        return self.class_named(target, other, depth + 1) if target else None

    def module(self, dotted: str, file: NodeSource) -> NodeSource | None:
        """The file of a module as another file imports it: ``package.module`` or ``.module``."""
        here = os.path.dirname(file.source.absolute)
        if (dotted, here) not in self._modules:
            self._modules[dotted, here] = self._find(dotted, here)
        return self._modules[dotted, here]

    def closure(self, file: NodeSource) -> list[NodeSource] | None:
        """A file and all of the workspace that it imports; None when a file is missing, or there are too many."""
        found, todo = {file.source: file}, [file]
        while todo:
            current = todo.pop()
            targets = [name for name in current.imports.values() if name is not None]
            for dotted in (*targets, *current.stars):
                other = self.module(dotted, current) or self.module(self._parent(dotted), current)
                if other is None and self._is_own(dotted):
                    return None
                if other is not None and other.source not in found:
                    found[other.source] = other
                    todo.append(other)
            if len(found) > CLOSURE or current.tree is None:
                return None
        return list(found.values())

    @staticmethod
    def _parent(dotted: str) -> str:
        """The module that a name is imported from."""
        module = dotted.rpartition(".")[0]
        if module.strip("."):
            return module
        return dotted[: len(dotted) - len(dotted.lstrip("."))] or dotted

    def _is_own(self, dotted: str) -> bool:
        """Whether a module should be one of the workspace's own."""
        top, _, rest = dotted.partition(".")
        return not top or (top in self._workspace.packages and rest.partition(".")[0] not in _GENERATED)

    def _find(self, dotted: str, here: str) -> NodeSource | None:
        level = len(dotted) - len(dotted.lstrip("."))
        path = dotted.lstrip(".").replace(".", "/")
        if level:
            folder = os.path.normpath(os.path.join(here, *[".."] * (level - 1)))
            return self._read(os.path.join(folder, path) if path else folder)
        owner = self._workspace.packages.get(path.partition("/")[0])
        for folder in (owner.folder, os.path.join(owner.folder, "src")) if owner is not None else (here,):
            found = self._read(os.path.join(folder, path))
            if found is not None:
                return found
        return None

    def _read(self, stem: str) -> NodeSource | None:
        for path in (f"{stem}.py", f"{stem}/__init__.py"):
            found = self.at(path)
            if found is not None:
                return found
        return None

    def at(self, path: str) -> NodeSource | None:
        """The file at an absolute path, read now if it was not known as a node; None when the tree does not hold it."""
        if path not in self.by_path:
            self.by_path[path] = None
            if path in set(self._tree.named(os.path.basename(path))):
                source = self._tree.read(path, judged=False)
                for found in self._parsed(parse, [source] if source is not None else []):
                    self.by_path[path] = found
                    self.by_source[found.source] = found
        return self.by_path[path]


def _inherit(node: NodeClass) -> None:
    if node.base is not None and node.base.is_node:
        node.is_node = True
        node.is_lifecycle = node.is_lifecycle or node.base.is_lifecycle
