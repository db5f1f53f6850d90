"""The device paths and camera indices that the sources of nodes name."""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.starters import STARTING
from bringup_lint.graph.host.device_uses import DeviceUse
from bringup_lint.parsers.cpp_node import parse as parse_cpp
from bringup_lint.parsers.python_node import parse as parse_python
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.model.node_source import NodeSource
    from bringup_lint.model.node_source import Parameter
    from bringup_lint.source import Source

_OPENING = frozenset({"serial.Serial", "cv2.VideoCapture", "open", "evdev.InputDevice", "os.open"})
_CAMERA = "cv2.VideoCapture"
_GIVING = (*STARTING, "params", "env-file", "launch-python", "launch-xml", "launch-yaml")
_IMPORT = regex(r"^from (?P<package>\w*)\.(?P<module>\w+) import ", re.M)
_NAMES = regex(r"/dev/|VideoCapture", hints="/dev/ VideoCapture")


def of_sources(files: Files) -> Iterator[DeviceUse]:
    """What nodes open under a literal path, and the defaults of parameters that no other file gives."""
    given = _Given([source.text for source in files.of_kind(*_GIVING)])
    for file in files.parsed(parse_python, _naming(files, "python-node")):
        if file.tree is not None:
            yield from _of_python(file, given)
    for file in files.parsed(parse_python, _modules(files)):
        yield from _of_python(file, given)
    for node in files.parsed(parse_cpp, _naming(files, "cpp-node")):
        for path in node.devices:
            yield DeviceUse(path, "the source of a node", "default")
        yield from _defaults(node.parameters, given)


def _defaults(parameters: Iterable[Parameter], given: _Given) -> Iterator[DeviceUse]:
    for parameter in parameters:
        path = parameter.default
        if isinstance(path, Located) and path.startswith("/dev/") and not given.has(str(parameter.name)):
            yield DeviceUse(path, f"the parameter {parameter.name}", "argument")


def _modules(files: Files) -> list[Source]:
    """The modules of the same package that nodes import, and that open something."""
    found: dict[str, Source] = {}
    for node in files.of_kind("python-node"):
        package = os.path.basename(os.path.dirname(node.absolute))
        for match in _IMPORT.finditer(node.text):
            if not node.judged or match["package"] not in ("", package):
                continue
            module = files.tree.beside(node, f"{match['module']}.py")
            if module is not None and module.judged and module.kind == "" and module.matches(_NAMES):
                found[module.name] = module
    return list(found.values())


def _naming(files: Files, kind: str) -> list[Source]:
    return [source for source in files.of_kind(kind) if source.judged and source.matches(_NAMES)]


class _Given:
    """What the files that start or configure nodes name."""

    def __init__(self, texts: list[str]) -> None:
        self._texts = texts
        self._known: dict[str, bool] = {}

    def has(self, parameter: str) -> bool:
        word = parameter.rpartition(".")[2]
        if word not in self._known:
            self._known[word] = any(word in text for text in self._texts)
        return self._known[word]


def _of_python(file: NodeSource, given: _Given) -> Iterator[DeviceUse]:
    for call in file.nodes:
        if not isinstance(call, ast.Call):
            continue
        name = file.qualified(call.func) or (call.func.id if isinstance(call.func, ast.Name) else "")
        opened = _opened(call) if name in _OPENING else None
        path = _path(file, opened, name) if opened is not None else None
        if path is not None:
            yield DeviceUse(path, "the source of a node", "default")
    for node in file.classes:
        yield from _defaults(node.parameters.values(), given)


def _opened(call: ast.Call) -> ast.expr | None:
    """The argument that names the device."""
    if call.args:
        return call.args[0]
    return next((each.value for each in call.keywords if each.arg in ("port", "index", "filename", "dev")), None)


def _path(file: NodeSource, node: ast.expr, name: str) -> Located | None:
    if not isinstance(node, ast.Constant):
        return None
    span = file.span_of(node)
    if isinstance(node.value, str) and node.value.startswith("/dev/"):
        return Located(node.value, span)
    index = node.value if name == _CAMERA and isinstance(node.value, int) and not isinstance(node.value, bool) else 0
    return Located(f"/dev/video{index}", span) if index > 0 else None
