"""Attributes of evaluated objects."""

from __future__ import annotations

import posixpath
from typing import Any

from bringup_lint.model.launch import Node
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Unknown
from bringup_lint.parsers.launch_python.functions import parent
from bringup_lint.parsers.launch_python.objects import Bound
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.source import Located
from bringup_lint.source import Span

_PATH_PARTS = frozenset(("name", "stem", "suffix", "parts"))
_SEPARATORS = {"os.sep": "/", "os.path.sep": "/", "os.linesep": "\n", "os.pathsep": ":"}


def attribute(state: State, owner: Any, name: str, span: Span) -> Any:
    kind = type(owner)
    if kind is Symbol:
        full = f"{owner.name}.{name}"
        if full in _SEPARATORS:
            return Literal(Located(_SEPARATORS[full], span), span)
        return Symbol(full, span)
    if kind in (PathJoin, FileDir, PackageShare):
        if name == "parent":
            return parent(owner, span)
        if name in _PATH_PARTS:
            return Unknown("path part", span)
    if kind is Literal and name == "parent" and isinstance(owner.value, str):
        return Literal(Located(posixpath.dirname(owner.value) or ".", span), span)
    if kind is Unknown:
        return Unknown(owner.why, span)
    if kind is Options and name == "parent":
        return Options([(guards, attribute(state, option, name, span)) for guards, option in owner.options], span)
    if kind is Node and name in ("name", "node_name"):
        return owner.name if owner.name is not None else Unknown("node name", span)
    return Bound(owner, name, span)
