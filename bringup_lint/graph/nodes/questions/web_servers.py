"""Web servers in the sources of nodes: those that listen on all addresses and ask nobody who they are."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.addresses import is_wildcard
from bringup_lint.graph.nodes.questions.motion import moves
from bringup_lint.graph.purpose import Purpose
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource
    from bringup_lint.source import Span

_SERVERS = {
    "uvicorn.run": "uvicorn",
    "websockets.serve": "websockets",
    "http.server.HTTPServer": "The HTTP server",
    "http.server.ThreadingHTTPServer": "The HTTP server",
    "aiohttp.web.run_app": "aiohttp",
}
_FLASK = ("flask.Flask", "flask_socketio.SocketIO")
_MENTIONED = regex(r"uvicorn|websockets|http|flask", hints="uvicorn websockets http flask")
_LOGIN = regex(
    r"auth|token|passw|login|secret|api_?key|jwt|credential|certfile|ssl_context|ssl_keyfile|allowed_(?:ips|hosts)",
    re.I,
)
"""What code that asks for a password or key has in it somewhere."""


def web_servers(nodes: Nodes) -> Iterator[tuple[str, str, Span]]:
    """``debugger`` or ``web``, the name of the server and its place, for the robot's own nodes."""
    for file in nodes.programs:
        if not file.source.matches(_MENTIONED):
            continue
        if nodes.purpose(file.source) is not Purpose.ROBOT or nodes.launch.workspace.is_vendored(file.source):
            continue
        syntax = nodes.syntax(file)
        for call in syntax.calls:
            name = _name(file, call, syntax.qualified(call), syntax.function(call))
            if name is None or not _is_open(call):
                continue
            if name == "Flask" and _is_true(call, "debug"):
                yield "debugger", name, file.span_of(call)
            elif _drives(nodes, file):
                yield "web", name, file.span_of(call)


def _name(file: NodeSource, call: ast.Call, dotted: str | None, function: ast.AST | None) -> str | None:
    """What a call serves with."""
    if dotted in _SERVERS:
        return _SERVERS[dotted]
    if not isinstance(call.func, ast.Attribute) or call.func.attr != "run":
        return None
    made = file.named(call.func.value, function)
    return "Flask" if made is not None and made in _FLASK else None


def _is_open(call: ast.Call) -> bool:
    """Whether the literal address is the wildcard; an address that is computed may be any."""
    given = next((each.value for each in call.keywords if each.arg == "host"), None)
    for each in (given, *call.args):
        if isinstance(each, ast.Tuple) and each.elts:
            each = each.elts[0]
        if isinstance(each, ast.Constant) and isinstance(each.value, str):
            return is_wildcard(each.value) or each.value == ""
    return False


def _is_true(call: ast.Call, keyword: str) -> bool:
    given = next((each.value for each in call.keywords if each.arg == keyword), None)
    return isinstance(given, ast.Constant) and given.value is True


def _drives(nodes: Nodes, file: NodeSource) -> bool:
    """Whether the program publishes what moves the robot, and nothing in it speaks of a login."""
    imported = nodes.imported(file)
    if imported is None or any(each.source.says(_LOGIN) for each in imported):
        return False
    endpoints = (endpoint for each in imported for node in each.classes for endpoint in node.endpoints)
    return any(endpoint.role == "publisher" and moves(endpoint) for endpoint in endpoints)
