"""Calls in callbacks that wait until a device, another program or the other side of a connection has done something."""

from __future__ import annotations

import ast
import re

from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.short_programs import is_long
from bringup_lint.graph.nodes.sources.stored_values import stored
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import is_own
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

UNTIL_BYTE = "until a byte arrives"
UNTIL_PACKET = "until the other side sends something"
UNTIL_END = "as long as the program runs"
_SERIAL = "serial.Serial"
_SOCKET = "socket.socket"
_PROGRAM = "subprocess.Popen"
_READS = {
    **dict.fromkeys(("read", "readline", "readlines", "read_until"), (_SERIAL, UNTIL_BYTE)),
    **dict.fromkeys(("recv", "recvfrom", "recv_into", "accept"), (_SOCKET, UNTIL_PACKET)),
    **dict.fromkeys(("communicate", "wait"), (_PROGRAM, UNTIL_END)),
}
"""Methods, what they are of, and how long they wait."""
_LIMITS = {
    _SERIAL: regex(r"\bin_?waiting\b|\.timeout\b|\bselect\b", re.I),
    _SOCKET: regex(
        r"settimeout|setblocking|setdefaulttimeout|select|MSG_DONTWAIT|SO_RCVTIMEO|O_NONBLOCK|create_connection"
    ),
    _PROGRAM: regex(r"\.(?:kill|terminate|send_signal|killpg|poll)\b"),
}
"""What in a file may keep the methods from waiting, or say that they need not."""
_TIMEOUT = 5
"""The position of the time-out among the arguments of a serial port."""


class DeviceRead(NamedTuple):
    what: str
    """The call in words."""
    how_long: str
    made: ast.expr | None
    """What opens the port, makes the socket or starts the program."""


def device_read(ending: Ending, call: ast.Call, cls: NodeClass) -> DeviceRead | None:
    """A call of a port, socket or process that has no time-out."""
    function = call.func
    if not isinstance(function, ast.Attribute) or function.attr not in _READS:
        return None
    kind, how_long = _READS[function.attr]
    if kind == _PROGRAM and (call.args or call.keywords):
        return None
    made = _made(ending.syntax, cls, function.value)
    if not made or ending.file.source.matches(_LIMITS[kind]):
        return None
    if not all(_waits(ending, kind, each) for each in made):
        return None
    owner = f"{kind}()" if isinstance(function.value, ast.Call) else written(function.value)
    return DeviceRead(f"{owner}.{function.attr}()", how_long, made[0])


def _made(syntax: Syntax, cls: NodeClass, owner: ast.expr) -> list[ast.expr | None]:
    """The values but ``None`` that an attribute of the node, or a variable of that name anywhere in the file, gets."""
    if isinstance(owner, ast.Call):
        return [owner]
    if is_own(owner):
        return stored(syntax, cls, owner)
    return syntax.once(_variables).get(owner.id, []) if isinstance(owner, ast.Name) else []


def _variables(syntax: Syntax) -> dict[str, list[ast.expr | None]]:
    """The values but ``None`` of the variables of a file by their names; None for what is not known."""
    found: dict[str, list[ast.expr | None]] = {}
    for node in syntax.file.nodes:
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            outer = next(syntax.above(node))[0]
            value = outer.value if isinstance(outer, (ast.Assign, ast.AnnAssign)) else None
            if not isinstance(value, ast.Constant) or value.value is not None:
                found.setdefault(node.id, []).append(value)
        elif isinstance(node, ast.arg):
            found.setdefault(node.arg, []).append(None)
    return found


def _waits(ending: Ending, kind: str, value: ast.expr | None) -> bool:
    if not isinstance(value, ast.Call) or ending.syntax.qualified(value) != kind:
        return False
    if kind == _SERIAL:
        return len(value.args) <= _TIMEOUT and not _has_timeout(value)
    return kind != _PROGRAM or is_long(ending, value)


def _has_timeout(call: ast.Call) -> bool:
    """Whether a port is opened with a time-out; None is none."""
    given = [each.value for each in call.keywords if each.arg in ("timeout", None)]
    return any(not isinstance(each, ast.Constant) or each.value is not None for each in given)
