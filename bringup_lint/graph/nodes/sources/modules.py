"""The Python modules of a workspace: which file an import names, and classes that build on classes of other files."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from functools import partial
from typing import TYPE_CHECKING
from typing import Any

from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.parsers.python_node import parse
from bringup_lint.parsers.python_node.values import UNKNOWN
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Workspace

Parsed = Callable[[Callable[[Source], NodeSource], Iterable[Source]], list[NodeSource]]

_DEPTH = 6
"""Files through which a class is followed."""
CLOSURE = 100
"""Files that one program imports."""
STEPS = 20
"""Files through which the value of a name is followed."""
_GENERATED = frozenset({"msg", "srv", "action"})
"""Modules of a package that are made from its interfaces."""


class Modules:
    """``files``: the sources of nodes; ``parsed`` reads one more, noting failures."""

    def __init__(self, tree: Tree, workspace: Workspace, files: list[NodeSource], parsed: Parsed) -> None:
        self._tree = tree
        self._workspace = workspace
        self._parsed = parsed
        self._alone: dict[str, NodeSource | None] = {file.source.absolute: file for file in files}
        """The files by their absolute paths, each read without the others."""
        self._places: dict[tuple[str, str], str | None] = {}
        self._values: dict[tuple[str, str], Any] = {}
        self._steps = 0
        self._names: dict[tuple[str, NodeSource], NodeClass | None] = {}
        self.files = [self._joined(file) for file in files]
        self.by_path: dict[str, NodeSource | None] = {file.source.absolute: file for file in self.files}
        self.by_source = {file.source: file for file in self.files}

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
        place = self._place(dotted, os.path.dirname(file.source.absolute))
        return self.at(place) if place is not None else None

    def let_go(self) -> None:
        """Forget the syntax of the files that were read with the values of others."""
        for file in self.by_source.values():
            if not file.is_alone:
                file.let_go()

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

    def imported(self, file: NodeSource) -> Iterator[NodeSource]:
        """The files of the tree that a file imports itself."""
        for name in self._imports(file):
            found = self.module(name, file) or self.module(self._parent(name), file)
            if found is not None:
                yield found

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

    def _place(self, dotted: str, here: str) -> str | None:
        """The path of a module of the tree, as a file in a folder imports it."""
        if (dotted, here) not in self._places:
            found = (path for path in self._candidates(dotted, here) if path in self._alone or path in self._there)
            self._places[dotted, here] = next(found, None)
        return self._places[dotted, here]

    def _candidates(self, dotted: str, here: str) -> Iterator[str]:
        level = len(dotted) - len(dotted.lstrip("."))
        path = dotted.lstrip(".").replace(".", "/")
        owner = self._workspace.packages.get(path.partition("/")[0]) if not level else None
        if level:
            folders = [os.path.normpath(os.path.join(here, *[".."] * (level - 1)))]
        elif owner is not None:
            folders = [owner.folder, os.path.join(owner.folder, "src")]
        else:
            around, name, _ = f"{here}/".rpartition(f"/{path.partition('/')[0]}/")
            folders = [here, around] if name else [here]
        for stem in (os.path.join(folder, path) if path else folder for folder in folders):
            yield from (f"{stem}.py", f"{stem}/__init__.py")

    @cached_property
    def _there(self) -> frozenset[str]:
        """The walked Python files."""
        return frozenset(path for path in self._tree.paths if path.endswith(".py"))

    def at(self, path: str) -> NodeSource | None:
        """The file at an absolute path, read now if it was not known as a node; None when the tree does not hold it."""
        if path not in self.by_path:
            found = self._read(path)
            self.by_path[path] = found = self._joined(found) if found is not None else None
            if found is not None:
                self.by_source[found.source] = found
        return self.by_path[path]

    def _read(self, path: str) -> NodeSource | None:
        """The file alone."""
        if path not in self._alone:
            source = self._tree.at(path) if self._tree.walks(path) else None
            self._alone[path] = next(iter(self._parsed(parse, [source] if source is not None else [])), None)
        return self._alone[path]

    def _joined(self, file: NodeSource) -> NodeSource:
        """A file with the values of what it imports from other files of the tree; itself where that is nothing."""
        if file.tree is None or next(self._imports(file), None) is None:
            return file
        value = partial(self._value, os.path.dirname(file.source.absolute))
        return next(iter(self._parsed(lambda source: file.joined(value), [file.source])), file)

    def _imports(self, file: NodeSource) -> Iterator[str]:
        """What a file imports of the tree, under its dotted name."""
        here = os.path.dirname(file.source.absolute)
        names = [name for name in file.imports.values() if name is not None]
        for name in (*names, *file.stars):
            if self._place(name, here) or self._place(self._parent(name), here):
                yield name

    def _value(self, here: str, dotted: str) -> Any:
        """The value of a dotted name for a file in a folder; UNKNOWN where no module of the tree makes it constant."""
        if (here, dotted) not in self._values:
            self._values[here, dotted] = UNKNOWN
            if self._steps < STEPS:
                self._steps += 1
                self._values[here, dotted] = self._exported(here, dotted)
                self._steps -= 1
        return self._values[here, dotted]

    def _exported(self, here: str, dotted: str) -> Any:
        module, path = dotted, list[str]()
        while (parent := self._parent(module)) != module:
            path.insert(0, module[len(parent) :].lstrip("."))
            module = parent
            place = self._place(module, here)
            other = self._read(place) if place is not None else None
            if other is not None and other.tree is not None:
                return other.exported(path, partial(self._value, os.path.dirname(other.source.absolute)))
        return UNKNOWN


def _inherit(node: NodeClass) -> None:
    if node.base is not None and node.base.is_node:
        node.is_node = True
        node.is_lifecycle = node.is_lifecycle or node.base.is_lifecycle
