"""Threads of Python programs that never end, and that the interpreter waits for at its end.

As tried with rclpy (Jazzy): after SIGTERM, main() ends and the process stays, for a loop that only sleeps, reads or
logs; ``publish()`` raises RCLError then, which ends the thread.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.device_reads import UNTIL_PACKET
from bringup_lint.graph.nodes.sources.device_reads import DeviceRead
from bringup_lint.graph.nodes.sources.device_reads import device_read
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.endless_loops import has_no_exit
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import Function
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import called_name
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_ENDS = regex(
    r"\.daemon\s{0,2}=\s{0,2}True|setDaemon\(True|os\._exit|os\.kill|os\.abort|\bclose\(|\.release\(|\.cancel\("
    r"|SIG_DFL|os\.killpg"
)
"""What makes a thread one that nobody waits for, ends the process, or makes what the thread waits for raise."""
_RAISES = frozenset(
    (
        *("publish", "call", "call_async", "send_goal_async", "sleep_for", "sleep_until", "wait_for_service"),
        *("spin", "spin_once", "spin_until_future_complete", "spin_once_until_future_complete"),
    )
)
"""Methods of rclpy that raise when the context is shut down."""
_ALL = frozenset({"Exception", "BaseException"})


class EndlessThread(NamedTuple):
    file: NodeSource
    started: ast.Call
    loop: ast.While
    function: str
    waits: DeviceRead | None = None
    """The read for which a loop that has an end waits."""


def endless_threads(nodes: Nodes) -> Iterator[EndlessThread]:
    """The threads, not daemons, of programs that spin, whose loops have no end that a shutdown could reach."""
    for file in nodes.robot_sources:
        text = file.source.text
        if "Thread(" not in text or "spin" not in text or _ENDS.search(text):
            continue
        ending = nodes.ending(file)
        for call in ending.syntax.named.get("threading.Thread", []):
            yield from _of(ending, call)


def _of(ending: Ending, call: ast.Call) -> Iterator[EndlessThread]:
    file, syntax = ending.file, ending.syntax
    given = {each.arg: each.value for each in call.keywords}
    cls = syntax.class_of(call)
    if "daemon" in given or None in given or cls is None or cls.is_node is not True or cls.method("__init__") is None:
        return
    name = _method(given.get("target"))
    method = cls.methods.get(name)
    if method is None:
        return
    loop = _loop(syntax, method.node, cls)
    if loop is not None:
        yield EndlessThread(file, call, loop, name)
        return
    yield from _deaf(ending, cls, method, call)


def _deaf(ending: Ending, cls: NodeClass, method: Function, started: ast.Call) -> Iterator[EndlessThread]:
    """The first loop of a method that asks whether it goes on only when the other side of a socket has sent
    something."""
    for loop in (each for each in body_of(method.node) if isinstance(each, ast.While)):
        reads = (device_read(ending, call, cls) for call in own_calls(loop.body))
        waits = next((each for each in reads if each is not None and each.how_long == UNTIL_PACKET), None)
        if waits is not None:
            yield EndlessThread(ending.file, started, loop, method.name, waits)
            return


def _method(target: ast.expr | None) -> str:
    """``x`` of ``self.x``."""
    is_own = isinstance(target, ast.Attribute) and written(target.value) == "self"
    return target.attr if is_own and isinstance(target, ast.Attribute) else ""


def _loop(syntax: Syntax, function: ast.AST, cls: NodeClass) -> ast.While | None:
    """The first loop of a method that nothing ends."""
    for each in body_of(function):
        if not isinstance(each, ast.While) or not isinstance(each.test, ast.Constant) or not each.test.value:
            continue
        calls = [call for call in reached(syntax, [each], cls) if isinstance(call, ast.Call)]
        if has_no_exit(each) and not any(_may_raise(syntax, call) for call in calls) and not _asks(each):
            return each
    return None


def _may_raise(syntax: Syntax, call: ast.Call) -> bool:
    """Whether a call ends the thread after the shutdown."""
    name = called_name(call)
    is_rate = name == "sleep" and syntax.qualified(call) != "time.sleep"
    return (name in _RAISES or "exit" in name or is_rate) and not syntax.catches(call, _ALL)


def _asks(loop: ast.While) -> bool:
    """Whether a loop asks rclpy whether it goes on."""
    return any(getattr(call.func, "attr", "") in ("ok", "is_set") for call in own_calls(loop.body))
