"""Requests that are sent before their service can be known, and whose answers are waited for without a time-out."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import called_name
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

_SPIN = "rclpy.spin_until_future_complete"
_LOOKS = ("wait_for_service", "service_is_ready", "wait_for_server", "server_is_ready")
_FIRST = ("__init__", "main")
_TIMEOUT = 3
"""The position of the time-out among the arguments of the spin."""


class LostRequest(NamedTuple):
    sent: ast.Call
    """``client.call_async(request)``."""
    spin: ast.Call
    client: Endpoint


def lost_requests(ending: Ending) -> Iterator[LostRequest]:
    """The waits of a file for the answer to a request that nothing keeps from being lost."""
    syntax = ending.syntax
    if any(each in ending.file.source.text for each in _LOOKS):
        return
    for spin in syntax.named.get(_SPIN, []):
        sent = _request(syntax, spin) if not _has_timeout(spin) and len(spin.args) > 1 else None
        client = _client(syntax, sent) if sent is not None else None
        if sent is not None and client is not None and _is_at_start(syntax, sent, client):
            yield LostRequest(sent, spin, client)


def _has_timeout(spin: ast.Call) -> bool:
    return len(spin.args) > _TIMEOUT or any(each.arg in ("timeout_sec", None) for each in spin.keywords)


def _request(syntax: Syntax, spin: ast.Call) -> ast.Call | None:
    """The one call whose answer a spin waits for."""
    given, function = spin.args[1], syntax.function(spin)
    if isinstance(given, ast.Call):
        return given if _sends(given) else None
    statements = own(function.body) if function is not None else ()
    made = [
        each.value
        for each in statements
        if isinstance(each, ast.Assign) and any(written(target) == written(given) for target in each.targets)
    ]
    first = made[0] if len(made) == 1 else None
    return first if isinstance(first, ast.Call) and _sends(first) else None


def _sends(call: ast.Call) -> bool:
    return isinstance(call.func, ast.Attribute) and call.func.attr == "call_async"


def _client(syntax: Syntax, sent: ast.Call) -> Endpoint | None:
    """The client that sends, where it is the only one that is kept there."""
    kept = written(sent.func.value)  # type: ignore[attr-defined]
    file = syntax.file
    every = (*(each for cls in file.classes for each in cls.endpoints), *file.strays)
    found = [each for each in every if each.attribute == kept and each.role == "client"]
    return found[0] if len(found) == 1 else None


def _is_at_start(syntax: Syntax, sent: ast.Call, client: Endpoint) -> bool:
    """Whether a request follows the making of its client at once, rather than some time later in a callback."""
    function = syntax.function(sent)
    if function is None or function.name == client.method:
        return True
    callers = {_name(syntax.function(call)) for call in syntax.calls if called_name(call) == function.name}
    return client.method in _FIRST and bool(callers) and callers <= {*_FIRST, ""}


def _name(function: FunctionNode | None) -> str:
    return function.name if function is not None else ""
