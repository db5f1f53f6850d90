"""Modules that a node imports from its own package, which has none of the name."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.tree_imports import may_fail
from bringup_lint.model.node_source import NodeSource
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.workspace import Package

_BUILT = regex(r"generat|Extension|ext_modules|cython|pybind|protoc|grpc|cmdclass|use_scm_version|setuptools_scm")
"""What setup.py says when the build makes modules."""
_MADE = regex(r"_pb2|_grpc\Z|version|_rc\Z|\Aui_|_ui\Z|parameters\Z|_params\Z|generated")
"""Modules that tools write."""
_SPECIAL = regex(r"[*?[]")
_INTERFACES = frozenset({"msg", "srv", "action"})


class MissingModule(NamedTuple):
    file: NodeSource
    statement: ast.ImportFrom
    module: str
    """As it is written: ``.pose``, ``crane.pose``."""
    path: str
    """The file that is not there, in the folder of the package."""
    function: str | None
    """The function that imports it; None: the file, when it is loaded."""


def missing_modules(nodes: Nodes) -> Iterator[MissingModule]:
    """Those of packages that setup.py installs as they are."""
    for file in nodes.robot_sources:
        owner = nodes.launch.workspace.owner(file.source)
        if owner is None or not _is_plain(nodes.files.tree, owner) or nodes.launch.workspace.is_vendored(file.source):
            continue
        for statement in (each for each in file.nodes if isinstance(each, ast.ImportFrom)):
            missing = _missing(nodes.files.tree, owner, file, statement)
            if missing is not None and not may_fail(nodes.syntax(file), statement):
                function = nodes.syntax(file).function(statement)
                module = "." * statement.level + (statement.module or "")
                yield MissingModule(file, statement, module, missing, function.name if function is not None else None)


def _is_plain(tree: Tree, owner: Package) -> bool:
    """Whether a package holds its modules as they are installed: nothing builds some of them."""
    setup = os.path.join(owner.folder, "setup.py")
    source = tree.read(setup, judged=False) if tree.is_file(setup) else None
    if source is None or source.matches(_BUILT) or tree.exists(os.path.join(owner.folder, "pyproject.toml")):
        return False
    return not tree.exists(os.path.join(owner.folder, "CMakeLists.txt"))


def _missing(tree: Tree, owner: Package, file: NodeSource, statement: ast.ImportFrom) -> str | None:
    """Where a module of the package should be, in its folder; None when it is there, or that is not known."""
    parts = (statement.module or "").split(".")
    if not statement.module:
        return None
    if statement.level:
        folder = os.path.normpath(os.path.join(os.path.dirname(file.source.absolute), *[".."] * (statement.level - 1)))
        if not folder.startswith(owner.folder + os.sep):
            return None
    else:
        folder = owner.folder
        is_own = parts[0] == owner.name and tree.is_file(os.path.join(folder, parts[0], "__init__.py"))
        if not is_own or parts[1:2] == [] or parts[1] in _INTERFACES or "sys.path" in file.source.text:
            return None
    path = _not_there(tree, folder, parts)
    return os.path.relpath(path, owner.folder) if path is not None else None


def _not_there(tree: Tree, folder: str, parts: list[str]) -> str | None:
    for part in parts:
        path = os.path.join(folder, part)
        if tree.is_file(f"{path}.py") or tree.is_link(path):
            return None
        if not tree.exists(path):
            is_known = tree.matches(f"{_quoted(folder)}/*.py") and not tree.matches(f"{_quoted(path)}[._]*")
            is_made = _MADE.search(part) or tree.is_ignored(f"{path}.py") or tree.is_ignored(path)
            return f"{path}.py" if is_known and not is_made else None
        folder = path
    return None


def _quoted(path: str) -> str:
    """A path in a shell pattern."""
    return _SPECIAL.sub(r"[\g<0>]", path)
