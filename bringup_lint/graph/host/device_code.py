"""The device paths and camera indices that the sources of nodes name."""

from __future__ import annotations

import ast
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.discover.starters import STARTING
from bringup_lint.graph.host.device_uses import DeviceUse
from bringup_lint.model.python import walk
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.model.node_source import NodeSource
    from bringup_lint.model.node_source import Parameter
    from bringup_lint.source import Source

_OPENING = frozenset({"serial.Serial", "cv2.VideoCapture", "open", "evdev.InputDevice", "os.open"})
_CAMERA = "cv2.VideoCapture"
_GIVING = (*STARTING, "params", "env-file", *LAUNCH)
_NAMES = regex(r"/dev/|VideoCapture", hints="/dev/ VideoCapture")
_OPENS = regex(r"/dev/|VideoCapture|\bSerial\b|\bInputDevice\b", hints="/dev/ VideoCapture Serial InputDevice")


def of_sources(files: Files, python: Callable[[], Iterable[NodeSource]]) -> Iterator[DeviceUse]:
    """What nodes open under a path that is known, and the defaults of parameters that no other file gives. ``python``
    gives the nodes in Python, with the modules that they import."""
    given = _Given([source.text for source in files.of_kind(*_GIVING)])
    if files.of_kind("python-node"):
        opening = (file for file in python() if file.source.judged and file.source.matches(_OPENS))
        yield from (use for file in opening if file.tree is not None for use in _of_python(file, given))
    if files.of_kind("cpp-node"):
        yield from _of_cpp(files, given)


def _of_cpp(files: Files, given: _Given) -> Iterator[DeviceUse]:
    from bringup_lint.parsers.cpp_node import parse

    for node in files.parsed(parse, _naming(files, "cpp-node")):
        for path in node.devices:
            yield DeviceUse(path, "the source of a node", "default")
        yield from _defaults(node.parameters, given)


def _defaults(parameters: Iterable[Parameter], given: _Given) -> Iterator[DeviceUse]:
    for parameter in parameters:
        path = parameter.default
        if isinstance(path, Located) and path.startswith("/dev/") and not given.has(str(parameter.name)):
            yield DeviceUse(path, f"the parameter {parameter.name}", "argument")


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
    opening: list[tuple[ast.Call, str, ast.expr]] = []
    for call in file.nodes:
        if isinstance(call, ast.Call):
            name = file.qualified(call.func) or (call.func.id if isinstance(call.func, ast.Name) else "")
            opened = _opened(call) if name in _OPENING else None
            if opened is not None:
                opening.append((call, name, opened))
    within = _functions(file) if any(not isinstance(opened, ast.Constant) for _, _, opened in opening) else {}
    for call, name, opened in opening:
        path = _path(file, opened, file.constant(opened, within.get(call)), name)
        if path is not None:
            yield DeviceUse(path, "the source of a node", "default", file.span_of(call))
    for node in file.classes:
        yield from _defaults(node.parameters.values(), given)


def _functions(file: NodeSource) -> dict[ast.AST, ast.AST]:
    """All syntax that is in a function -> the innermost."""
    found: dict[ast.AST, ast.AST] = {}
    for each in file.nodes:
        if isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef)):
            found.update(dict.fromkeys(walk(each), each))
    return found


def _opened(call: ast.Call) -> ast.expr | None:
    """The argument that names the device."""
    if call.args:
        return call.args[0]
    return next((each.value for each in call.keywords if each.arg in ("port", "index", "filename", "dev")), None)


def _path(file: NodeSource, node: ast.expr, value: object, name: str) -> Located | None:
    """The device of an argument with a value, as far as it is known."""
    if isinstance(value, Located):
        return value if value.startswith("/dev/") else None
    index = value if name == _CAMERA and isinstance(value, int) and not isinstance(value, bool) else 0
    return Located(f"/dev/video{index}", file.span_of(node)) if index > 0 else None
