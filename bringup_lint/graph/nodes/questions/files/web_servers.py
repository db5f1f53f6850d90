"""Servers in the sources of nodes: those that listen on all addresses and ask nobody who they are."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.addresses import is_wildcard
from bringup_lint.graph.nodes.questions.files.server_addresses import Address
from bringup_lint.graph.nodes.questions.files.server_addresses import Settings
from bringup_lint.graph.nodes.questions.files.server_addresses import address_of
from bringup_lint.graph.nodes.sources.motion import is_commanding
from bringup_lint.graph.purpose import Purpose
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_node.values import argument
from bringup_lint.parsers.python_node.values import keyword
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.nodes.sources.syntax import Syntax
    from bringup_lint.source import Span


class Server(NamedTuple):
    """How a library is told where to listen."""

    name: str
    at: int
    """The position of the address, or of the pair of address and port; -1: it has a keyword alone."""
    keyword: str = "host"
    is_open: bool = False
    """It listens on all addresses where none is given."""


_HTTP = Server("The HTTP server", 0, "server_address")
_WEBSOCKETS = Server("websockets", 1, is_open=True)
_TCP = Server("The TCP server", 0, "server_address")
_SERVERS = {
    "uvicorn.run": Server("uvicorn", -1),
    "uvicorn.Config": Server("uvicorn", 1),
    "websockets.serve": _WEBSOCKETS,
    "websockets.server.serve": _WEBSOCKETS,
    "websockets.asyncio.server.serve": _WEBSOCKETS,
    "websockets.sync.server.serve": _WEBSOCKETS,
    "http.server.HTTPServer": _HTTP,
    "http.server.ThreadingHTTPServer": _HTTP,
    "wsgiref.simple_server.make_server": Server("The HTTP server", 0),
    "gevent.pywsgi.WSGIServer": Server("gevent", 0, "listener"),
    "aiohttp.web.run_app": Server("aiohttp", -1, is_open=True),
    "aiohttp.web.TCPSite": Server("aiohttp", 1, is_open=True),
    "nicegui.ui.run": Server("NiceGUI", -1, is_open=True),
    "waitress.serve": Server("waitress", -1, is_open=True),
    "bottle.run": Server("Bottle", -1),
    "asyncio.start_server": Server("The TCP server", 1, is_open=True),
    "socketserver.TCPServer": _TCP,
    "socketserver.ThreadingTCPServer": _TCP,
    "socketserver.UDPServer": Server("The UDP server", 0, "server_address"),
    "xmlrpc.server.SimpleXMLRPCServer": Server("The XML-RPC server", 0, "addr"),
    "websocket_server.WebsocketServer": Server("The WebSocket server", -1),
}
_FLASK = Server("Flask", 0)
_METHODS = {
    ("flask.Flask", "run"): _FLASK,
    ("flask_socketio.SocketIO", "run"): Server("Flask", 1),
    ("quart.Quart", "run"): Server("Quart", 0),
    ("dash.Dash", "run"): Server("Dash", 0),
    ("dash.Dash", "run_server"): Server("Dash", 0),
    ("sanic.Sanic", "run"): Server("Sanic", 0),
    ("tornado.web.Application", "listen"): Server("Tornado", 1, "address", is_open=True),
    ("tornado.httpserver.HTTPServer", "listen"): Server("Tornado", 1, "address", is_open=True),
    ("socket.socket", "bind"): Server("The socket", 0, "address"),
}
"""Class and method of a server."""
_LIMITS = ("native", "sock", "sockets", "unix", "path", "fd", "uds", "listen", "unix_socket")
"""Keywords by which a server listens elsewhere than on an address of the network."""
_MENTIONED = regex(
    r"uvicorn|websocket|http|flask|aiohttp|nicegui|waitress|bottle|socketserver|socket|xmlrpc|tornado|sanic|quart|dash"
    r"|gevent|wsgiref|asyncio",
    hints="uvicorn websocket http flask nicegui waitress bottle socket xmlrpc tornado sanic quart dash gevent wsgiref "
    "asyncio",
)
_LOGIN = regex(
    r"auth(?!or(?!i))|[\"'](?:x-)?token[\"']|(?-i:\bTOKEN\b)|(?<![a-z]_)token\s{0,2}[!=]="
    r"|(?:access|api|auth|secret|session|user|admin|bearer|robot|control|server|http|web|ws|csrf)[_-]?token"
    r"|passw|(?<!get)login|secret(?!_?key|[\"']\s{0,4}$)|api_?key|jwt|credential|certfile|ssl_context|ssl_keyfile|allowed_(?:ips|hosts)"
    r"|whitelist|allowlist",
    re.I | re.M,
)
"""What code that asks for a password or key has in it somewhere; the key with which Flask signs its cookies is none."""
_SIMULATES = regex(r"gazebo|isaac_?sim|webots", re.I)
"""The names of simulators: a server beside them drives a model. A mode without hardware is no simulator."""
_TAKES = regex(
    r"do_(?:POST|PUT)|self\.path|methods\s?=|\.(?:post|put|add_post|websocket|route|on|on_event)\(|WebSocket|recv|on_message"
    r"|async for \w{1,40} in|ui\.(?:button|slider|joystick|keyboard|switch)|register_function|readline|\.read\("
)
"""What code that takes something from its clients has in it."""


def web_servers(nodes: Nodes) -> Iterator[tuple[str, str, Span, Span | None]]:
    """``debugger`` or ``web``, the name of the server, its place and that of the setting whose default is its address,
    for the robot's own nodes."""
    settings = Settings(nodes.files)
    for file in nodes.robot_sources:
        if not file.source.matches(_MENTIONED):
            continue
        if nodes.purpose(file.source) is not Purpose.ROBOT or nodes.launch.workspace.is_vendored(file.source):
            continue
        syntax = nodes.syntax(file)
        for call in syntax.calls:
            server, serving = _server(syntax, call)
            address = _address(settings, syntax, serving, server) if server is not None else None
            if server is None or address is None or not is_wildcard(address.text):
                continue
            if server is _FLASK and _is_true(serving, "debug"):
                yield "debugger", server.name, file.span_of(call), address.default
            elif _drives(nodes, syntax):
                yield "web", server.name, file.span_of(call), address.default


def _server(syntax: Syntax, call: ast.Call) -> tuple[Server | None, ast.Call]:
    """What a call serves with, and the call with its arguments: ``Thread(target=app.run, kwargs={...})`` makes one."""
    if (syntax.qualified(call) or "") == "threading.Thread":
        target = keyword(call, "target")
        made = _made_by_thread(call, target) if isinstance(target, ast.Attribute) else None
        return (_of_function(syntax, call, made.func), made) if made is not None else (None, call)
    return _of_function(syntax, call, call.func), call


def _made_by_thread(thread: ast.Call, target: ast.expr) -> ast.Call:
    """The call that a thread makes."""
    words, values = keyword(thread, "kwargs"), keyword(thread, "args")
    keywords = [ast.keyword(None, words)] if words is not None else []
    if isinstance(words, ast.Dict):
        pairs = ((key, value) for key, value in zip(words.keys, words.values) if isinstance(key, ast.Constant))
        keywords = [ast.keyword(str(key.value), value) for key, value in pairs]
    elif isinstance(words, ast.Call) and isinstance(words.func, ast.Name) and words.func.id == "dict":
        keywords = words.keywords
    return ast.Call(target, values.elts if isinstance(values, (ast.Tuple, ast.List)) else [], keywords)


def _of_function(syntax: Syntax, call: ast.Call, function: ast.expr) -> Server | None:
    dotted = syntax.file.qualified(function) or _of_import(syntax, function)
    if dotted in _SERVERS:
        return _SERVERS[dotted]
    if isinstance(function, ast.Name):
        bases = syntax.once(_bases).get(function.id, ())
        return next((_SERVERS[base] for base in bases if base in _SERVERS), None)
    if not isinstance(function, ast.Attribute):
        return None
    made = syntax.file.named(function.value, syntax.function(call))
    return _METHODS.get((made or "", function.attr))


def _of_import(syntax: Syntax, function: ast.expr) -> str | None:
    """The dotted name of a function of a module that is None where the import fails."""
    if not isinstance(function, ast.Attribute) or not isinstance(function.value, ast.Name):
        return None
    module = syntax.file.imports.get(function.value.id)
    return f"{module}.{function.attr}" if module else None


def _bases(syntax: Syntax) -> dict[str, list[str | None]]:
    """The classes of the file and what they build on."""
    classes = (node for node in syntax.file.nodes if isinstance(node, ast.ClassDef))
    return {node.name: [syntax.file.qualified(base) for base in node.bases] for node in classes}


def _address(settings: Settings, syntax: Syntax, call: ast.Call, server: Server) -> Address | None:
    if any(each.arg is None or each.arg in _LIMITS for each in call.keywords):
        return None
    given = argument(call, server.at, server.keyword)
    if given is None or (isinstance(given, ast.Constant) and given.value is None):
        return Address("") if server.is_open else None
    return address_of(settings, syntax, given)


def _is_true(call: ast.Call, keyword: str) -> bool:
    given = next((each.value for each in call.keywords if each.arg == keyword), None)
    return isinstance(given, ast.Constant) and given.value is True


def _drives(nodes: Nodes, syntax: Syntax) -> bool:
    """Whether the program publishes what moves the robot, takes something from its clients, and nothing in it speaks
    of a login."""
    imported = nodes.imported(syntax.file)
    if imported is None or any(each.source.says(_LOGIN) for each in imported):
        return False
    if syntax.file.source.matches(_SIMULATES):
        return False
    if not any(each.source.matches(_TAKES) for each in imported):
        return False
    endpoints = (each for file in imported for each in (*file.strays, *(e for n in file.classes for e in n.endpoints)))
    return any(is_commanding(each) for each in endpoints)
