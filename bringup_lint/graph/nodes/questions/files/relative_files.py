"""Files of the tree that Python nodes open by a path that counts from wherever the program was started."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.questions.relative_paths import FOLDER
from bringup_lint.graph.nodes.sources.file_calls import LOADS
from bringup_lint.graph.nodes.sources.file_calls import OPENS
from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_PATH = regex(r"(?:\.{1,2}/){0,8}\w[\w./ -]{0,200}\.[A-Za-z0-9]{1,8}\Z")
_READS = OPENS | {"changeMap"}
"""Functions whose first argument is a file that they read; ``open`` unless its mode says otherwise."""
_MOVES = regex(r"\bchdir\b|\b__file__\b[^\n]{0,200}\bopen\b", hints="chdir __file__")


class RelativeFile(NamedTuple):
    file: NodeSource
    place: ast.expr
    path: str
    folder: str
    """Where the tree has the file, so that the program must be started there, in words."""
    call: str
    idle: bool


def relative_files(nodes: Nodes) -> Iterator[list[RelativeFile]]:
    """Those of programs and modules of packages, all of a source together."""
    for file in nodes.robot_sources:
        if nodes.launch.workspace.owner(file.source) is None or _MOVES.search(file.source.text):
            continue
        found = list(_in_file(nodes, file, nodes.syntax(file)))
        if found:
            yield found


def _in_file(nodes: Nodes, file: NodeSource, syntax: Syntax) -> Iterator[RelativeFile]:
    for call in syntax.calls:
        name = written(call.func).rpartition(".")[2]
        if not call.args or not _reads(syntax, call, name):
            continue
        value = file.constant(call.args[0], syntax.function(call))
        path = value if isinstance(value, str) and _PATH.match(value) else None
        folder = _folder(nodes, file, path) if path is not None else None
        if path is not None and folder is not None and not syntax.is_dead(call):
            yield RelativeFile(file, call.args[0], path, folder, name, is_idle(syntax, call))


def _reads(syntax: Syntax, call: ast.Call, name: str) -> bool:
    if name == "open":
        modes = [each.value for each in call.keywords if each.arg == "mode"] + call.args[1:2]
        is_reading = all(isinstance(each, ast.Constant) and str(each.value).startswith("r") for each in modes)
        return isinstance(call.func, ast.Name) and is_reading
    return name in _READS or syntax.qualified(call) in LOADS


def _folder(nodes: Nodes, file: NodeSource, path: str) -> str | None:
    """The folder above the source, or its own, that has the file; None when none does, or when the tree chooses a
    working directory and has the file above the package."""
    tree, owner = nodes.files.tree, nodes.launch.workspace.owner(file.source)
    tops = {os.path.abspath(top) for top in tree.tops}
    folder = os.path.dirname(file.source.absolute)
    while not tree.is_file(os.path.normpath(os.path.join(folder, path))):
        if folder in tops or os.path.dirname(folder) == folder:
            return None
        folder = os.path.dirname(folder)
    if owner is None or len(folder) < len(owner.folder):
        return None if nodes.files.mentions(FOLDER) else "the folder of the workspace"
    return os.path.relpath(folder, os.path.dirname(owner.folder))
