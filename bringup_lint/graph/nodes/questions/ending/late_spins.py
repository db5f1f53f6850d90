"""Spins that come after a call which runs until the program ends."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_SERVERS = {
    "flask.Flask": "run",
    "http.server.HTTPServer": "serve_forever",
    "http.server.ThreadingHTTPServer": "serve_forever",
    "socketserver.TCPServer": "serve_forever",
    "socketserver.UDPServer": "serve_forever",
    "tkinter.Tk": "mainloop",
}
"""What makes a server or window, and the method that runs it until it is stopped."""
_FUNCTIONS = frozenset({"uvicorn.run", "waitress.serve", "tkinter.mainloop"})
_MENTIONED = regex(
    r"flask|http|socketserver|tkinter|uvicorn|waitress", hints="flask http socketserver tkinter uvicorn waitress"
)
_SPINS = frozenset({"rclpy.spin"})
_OTHERS = regex(
    r"[Tt]hread\(|[Tt]hread\.|\bTimer\(|Process\(|spin_once|spin_some|(?<!\brclpy)\.spin\b|\.spin\b(?!\s*\()|fork\(|run_in_executor|submit\("
    r"|create_task|ensure_future|call_soon"
)
"""What may spin the node beside the server."""


_STARTS = regex(r"spin|start|run|ros|background|loop", re.I)
"""Names of functions that may spin a node which they are given."""
_ENDS = regex(r"(?<!\brclpy)\.(?:destroy|quit|shutdown)\b")
"""What ends a server or window while the program goes on."""


class LateSpin(NamedTuple):
    spin: ast.Call
    server: ast.Call


def late_spins(syntax: Syntax) -> Iterator[LateSpin]:
    """The first spin in the plain statements after each server."""
    source = syntax.file.source
    if not source.matches(_MENTIONED):
        return
    spins = {call for name in _SPINS for call in syntax.named.get(name, [])}
    if not spins or source.matches(_OTHERS) or source.matches(_ENDS):
        return
    for call in syntax.calls:
        statement = next(syntax.above(call), (None, ""))[0]
        if not isinstance(statement, ast.Expr) or not _runs_on(syntax, call):
            continue
        late = next((each for each in own_calls(list(syntax.after(statement))) if each in spins), None)
        if late is not None and not _may_start(syntax, late):
            yield LateSpin(late, call)


def _may_start(syntax: Syntax, spin: ast.Call) -> bool:
    """Whether the node is given to another function that may spin it in a thread."""
    node = written(spin.args[0]) if spin.args else ""
    return any(
        call is not spin and _STARTS.search(written(call.func)) and node in map(written, call.args)
        for call in syntax.calls
    )


def _runs_on(syntax: Syntax, call: ast.Call) -> bool:
    if syntax.qualified(call) in _FUNCTIONS:
        return True
    if not isinstance(call.func, ast.Attribute):
        return False
    made = syntax.file.named(call.func.value, syntax.function(call)) or ""
    return _SERVERS.get(made) == call.func.attr
