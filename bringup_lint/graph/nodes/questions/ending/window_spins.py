"""Threads of Python programs that spin on when the window of the program is closed, so that it never ends."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_WINDOWS = frozenset({"exec", "exec_", "mainloop"})
"""Methods that return when the last window is closed."""
_TOOLKITS = ("PyQt", "PySide", "python_qt_binding", "tkinter", "customtkinter", "qtpy")
_ENDS = regex(r"\.(?:try_)?shutdown\(|os\._exit|os\.kill|os\.abort|\.daemon\b|setDaemon|\bspin_once\b")
"""What ends the spin or the process, or makes the thread one that nobody waits for."""


class WindowSpin(NamedTuple):
    file: NodeSource
    started: ast.Call
    window: ast.Call


def window_spins(nodes: Nodes) -> Iterator[WindowSpin]:
    """The spins in threads, not daemons, of a function that shows a window after it has started them."""
    for file in nodes.robot_sources:
        text = file.source.text
        has_window = any((name or "").startswith(_TOOLKITS) for name in file.imports.values())
        if not has_window or "Thread(" not in text or _ENDS.search(text):
            continue
        syntax = nodes.syntax(file)
        for call in syntax.named.get("threading.Thread", []):
            given = {each.arg: each.value for each in call.keywords}
            if not given.keys() & {"daemon", None} and _is_spin(given.get("target")):
                window = _window(syntax, call)
                if window is not None:
                    yield WindowSpin(file, call, window)


def _is_spin(target: ast.expr | None) -> bool:
    """``rclpy.spin``, ``executor.spin``, or a lambda that calls one of them."""
    if isinstance(target, ast.Lambda) and isinstance(target.body, ast.Call):
        target = target.body.func
    return isinstance(target, ast.Attribute) and target.attr == "spin"


def _window(syntax: Syntax, started: ast.Call) -> ast.Call | None:
    later = (each for each in own_calls(body_of(syntax.function(started))) if each.lineno > started.lineno)
    return next((each for each in later if isinstance(each.func, ast.Attribute) and each.func.attr in _WINDOWS), None)
