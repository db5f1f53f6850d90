"""Files of home folders that Python nodes open: those of a person whom nothing else in the tree knows, and those that a
package of the tree would have and has not."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
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

_HOME = regex(r"/home/(?P<user>[A-Za-z_][\w.-]{0,60})/[^\s<>${}*]{1,300}\Z")
_CAUGHT = frozenset({"Exception", "BaseException", "OSError", "IOError", "FileNotFoundError"})
_AUTHORED = regex(r"\.(?:py|sh|ya?ml|json|xml|urdf|xacro|srdf|sdf|lua|rviz|csv|launch)\Z")
"""Files that people write and keep in their repository; models, maps and logs are made on the robot."""
_CODE = ("python-node", "cpp-node", *LAUNCH, "params", "ros-package", "setup-py")
"""Kinds of file whose paths are no sign that the robot has a user."""
_LAUNCHED = (*LAUNCH, "params")
_ELSE = (ast.If, ast.IfExp, ast.ExceptHandler, ast.Match)


class HomeFile(NamedTuple):
    file: NodeSource
    place: ast.expr
    path: str
    call: str
    """The function that opens it, or ``declare_parameter``."""
    home: str
    """``/home/anna``."""
    missing: str
    """The path of the file in its package, which the tree does not have; empty for a home that nothing else knows."""
    idle: bool


def home_files(nodes: Nodes) -> Iterator[HomeFile]:
    homes = _Homes(nodes)
    for file in nodes.robot_sources:
        if "/home/" in file.source.text:
            syntax = nodes.syntax(file)
            for call in syntax.calls:
                yield from _in_call(homes, file, syntax, call)


def _in_call(homes: _Homes, file: NodeSource, syntax: Syntax, call: ast.Call) -> Iterator[HomeFile]:
    name = written(call.func).rpartition(".")[2]
    is_default = name == "declare_parameter" and len(call.args) > 1
    if not is_default and not (call.args and (name in OPENS or syntax.qualified(call) in LOADS)):
        return
    place = call.args[1] if is_default else call.args[0]
    value = file.constant(place, syntax.function(call))
    path = value if isinstance(value, str) else ""
    match = _HOME.match(path)
    if match is None or syntax.is_dead(call) or syntax.catches(call, _CAUGHT):
        return
    if any(isinstance(outer, _ELSE) for outer, _ in syntax.within(call)):
        return
    missing = homes.missing(path)
    if is_default and (not missing or homes.is_given(call.args[0], path)):
        return
    if missing or not homes.is_known(match["user"]):
        home = path[: match.end("user")]
        yield HomeFile(file, place, path, name, home, missing, is_idle(syntax, call))


class _Homes:
    """What the tree says of users and of its own files."""

    def __init__(self, nodes: Nodes) -> None:
        self._nodes = nodes
        self._known: dict[str, bool] = {}

    @cached_property
    def _texts(self) -> list[str]:
        """What may tell that the robot has a user: units, scripts, images, and all else that is no code."""
        sources = self._nodes.files.sources
        code = {each for kind in _CODE for each in self._nodes.files.of_kind(kind)}
        return [each.text for each in sources if each not in code]

    def is_known(self, user: str) -> bool:
        if user not in self._known:
            name = re.escape(user)
            form = re.compile(
                rf"/home/{name}(?![\w.-])|\bUser={name}\s|\bUSER[ =]{name}\b|\b{name}@"
                rf"|\b(?:useradd|adduser|chown|usermod|su|user|name|username)\b[^\n]{{0,200}}\b{name}\b"
            )
            self._known[user] = any(user in text and form.search(text) for text in self._texts)
        return self._known[user]

    def missing(self, path: str) -> str:
        """The rest of a path after the folder of a package of the tree, where the package has no such file, and git
        would not ignore it."""
        if not _AUTHORED.search(path):
            return ""
        parts = path.split("/")
        tree, found = self._nodes.files.tree, ""
        for folder in sorted(self._packages.keys() & parts):
            rest = "/".join(parts[parts.index(folder) + 1 :])
            places = [os.path.join(package, rest) for package in self._packages[folder]]
            if any(tree.exists(each) or tree.is_ignored(each) for each in places):
                return ""
            found = f"{folder}/{rest}" if "install" not in parts and "share" not in parts else ""
        return found

    @cached_property
    def _packages(self) -> dict[str, list[str]]:
        """Name of a package, or of its folder -> the folders: a package is often the whole repository."""
        found: dict[str, list[str]] = {}
        for package in self._nodes.launch.workspace.packages.values():
            for name in {os.path.basename(package.folder), package.name}:
                found.setdefault(name, []).append(package.folder)
        return found

    def is_given(self, name: ast.expr, path: str) -> bool:
        """Whether a launch or parameter file may give a parameter another path."""
        word = name.value if isinstance(name, ast.Constant) else None
        texts = (each.text for each in self._nodes.files.of_kind(*_LAUNCHED))
        return not isinstance(word, str) or any(word in text and path not in text for text in texts)
