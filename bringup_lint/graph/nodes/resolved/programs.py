"""From a package and an executable to the Python source that runs, and the nodes that it makes."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.nodes.sources.modules import Modules
from bringup_lint.graph.workspace import Package
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import walk
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.workspace import Workspace

FUNCTIONS = 20
"""Functions of a file that are followed from its entry on."""


@dataclass(frozen=True, slots=True)
class Program:
    """An executable of a package that is written in Python."""

    file: NodeSource
    function: str | None
    """The function that is called; None when the whole file runs."""
    classes: tuple[NodeClass, ...]
    """The nodes that it makes, each class once."""
    declared: Located | None
    """Where the build description names it."""


def program_of(workspace: Workspace, modules: Modules, package: str, executable: str) -> Program | None:
    """The Python program that ``ros2 run package executable`` starts."""
    owner = workspace.packages.get(package)
    if owner is None:
        return None
    declared = owner.executables.get(executable)
    target = owner.entry_points.get(executable)
    if target:
        module, _, function = target.partition(":")
        file = _module(modules, owner, module)
        return _program(modules, file, function or None, declared) if file is not None else None
    for origin in owner.origins(f"lib/{package}/{executable}"):
        file = modules.at(origin) if origin.endswith(".py") or "." not in os.path.basename(origin) else None
        if file is not None and file.tree is not None:
            return _program(modules, file, None, declared)
    return None


def _module(modules: Modules, owner: Package, dotted: str) -> NodeSource | None:
    path = dotted.replace(".", "/")
    for folder in (owner.folder, os.path.join(owner.folder, "src")):
        for stem in (f"{path}.py", f"{path}/__init__.py"):
            file = modules.at(os.path.join(folder, stem))
            if file is not None:
                return file
    return None


def _program(modules: Modules, file: NodeSource, function: str | None, declared: Located | None) -> Program:
    for _ in range(3):
        imported = file.imports.get(function) if function is not None and function not in file.functions else None
        module, _, name = (imported or "").rpartition(".")
        other = modules.module(module, file) if module else None
        if other is None:
            break
        file, function = other, name
    start = function if function in file.functions else None
    classes = list(dict.fromkeys(made(modules, file, start or file.main or None)))
    return Program(file, start, tuple(classes), declared)


def made(modules: Modules, file: NodeSource, function: str | None) -> Iterator[NodeClass]:
    """The nodes that a function, or the whole file, makes; functions of the same file are followed."""
    start = file.functions[function].node if function in file.functions else file.tree
    todo: list[ast.AST] = [start] if start is not None else []
    seen = {function}
    singles = {(each.span.start, each.span.end): each for each in file.classes if each.name is None}
    while todo and len(seen) < FUNCTIONS:
        top = todo.pop()
        for node in file.nodes if top is file.tree else walk(top):
            if not isinstance(node, ast.Call):
                continue
            if isinstance(node.func, ast.Name) and node.func.id in file.functions and node.func.id not in seen:
                seen.add(node.func.id)
                todo.append(file.functions[node.func.id].node)
            span = file.span_of(node)
            single = singles.get((span.start, span.end))
            name = file.qualified(node.func)
            found = single or (modules.class_named(name, file) if name else None)
            if found is not None and found.is_node:
                yield found
