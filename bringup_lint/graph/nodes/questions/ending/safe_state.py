"""Whether a node that moves something stops it when it ends."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.graph.nodes.questions.ending.stopping import is_on_shutdown
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.motion import is_velocity
from bringup_lint.graph.nodes.sources.motion import moves
from bringup_lint.graph.nodes.sources.sending import published
from bringup_lint.graph.nodes.sources.sending import sendings
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import Function
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import called_name
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_ENDS = ("on_deactivate", "on_shutdown", "on_cleanup", "on_error", "destroy_node", "__del__", "__exit__")
_STOP_WORDS = regex(r"stop|zero|halt|brake|safe|estop|e_stop|disable|disarm|idle|shutdown|cleanup|close", re.I)


def commands(node: NodeClass) -> list[Endpoint]:
    """The publishers of a node that move something."""
    return [each for each in node.all_endpoints if each.role == "publisher" and moves(each)]


def relays(node: NodeClass) -> bool:
    """Whether a node passes commands on that it gets from another one."""
    wanted = {each.type for each in commands(node)}
    heard = [each for each in node.all_endpoints if each.role == "subscription"]
    return any(each.type in wanted or moves(each) or is_velocity(each) for each in heard)


def stops_itself(syntax: Syntax, node: NodeClass) -> bool:
    """Whether each method that commands a motion waits and ends it itself, so that none outlasts a callback."""
    found = [method for method in node.methods.values() if _commands(syntax, body_of(method.node), node)]
    return bool(found) and all(_ends_motion(syntax, method.node, node) for method in found)


def _commands(syntax: Syntax, body: Sequence[ast.AST], node: NodeClass) -> bool:
    return any(moves(each.endpoint) for each in sendings(syntax, body, node))


def _ends_motion(syntax: Syntax, method: FunctionNode, node: NodeClass) -> bool:
    """Whether the last command is a fresh message, all zero, that is sent in any case after a wait."""
    last = next((each for each in reversed(method.body) if _commands(syntax, [each], node)), None)
    if not isinstance(last, ast.Expr) or not isinstance(last.value, ast.Call):
        return False
    before = method.body[: method.body.index(last)]
    waits = any(syntax.qualified(call) == "time.sleep" for call in own_calls(before))
    made = before[-1].value if before and isinstance(before[-1], ast.Assign) else None
    return waits and any(_is_fresh(each) for each in (made, *last.value.args))


def _is_fresh(value: ast.expr | None) -> bool:
    return isinstance(value, ast.Call) and not value.args and not value.keywords


def is_watched_relay(node: NodeClass, command: Endpoint) -> bool:
    """Whether a node passes a command on and has a timer, which can end it when no more come."""
    heard = [each for each in node.all_endpoints if each.role == "subscription" and each.name and command.name]
    named = any(str(each.name).strip("/") == str(command.name).strip("/") for each in heard)
    return named and bool(node.all_timers) and bool(commands(node))


def has_safe_state(ending: Ending, nodes: list[NodeClass]) -> bool:
    """Whether a file does anything at the end that could be a stop command, well or badly."""
    if ending.handlers or any(is_on_shutdown(call) for call in ending.syntax.calls):
        return True
    if "atexit.register" in ending.syntax.named:
        return True
    for node in nodes:
        for name in _ENDS:
            method = node.method(name)
            if method is not None and _is_stop(ending.syntax, body_of(method.node), node):
                return True
    return any(_is_stop(ending.syntax, block, None) for block in _last_blocks(ending))


def _last_blocks(ending: Ending) -> Iterator[list[ast.stmt]]:
    """What runs when something else is over: ``finally``, ``except``, and the statements behind a spin."""
    for node in ending.file.nodes:
        if isinstance(node, ast.Try):
            yield node.finalbody
            yield from (handler.body for handler in node.handlers)
    for spin in ending.spins:
        for outer, _ in ending.syntax.within(spin.call):
            if isinstance(outer, ast.stmt):
                yield ending.syntax.after(outer)


def _is_stop(syntax: Syntax, block: Sequence[ast.AST], cls: NodeClass | None) -> bool:
    if next(sendings(syntax, block, cls), None) is not None:
        return True
    for call in own_calls(block):
        name = called_name(call)
        if name == "publish" or (_STOP_WORDS.search(name) and (syntax.qualified(call) or "")[:6] != "rclpy."):
            return True
    return False


class PublishAfterDeactivate(NamedTuple):
    """``deactivate`` is before ``publish`` in a transition of a lifecycle node."""

    method: Function
    deactivate: ast.stmt
    publish: ast.stmt
    endpoint: Endpoint


def publish_after_deactivate(syntax: Syntax, node: NodeClass) -> Iterator[PublishAfterDeactivate]:
    """The messages that a lifecycle publisher drops, because it was deactivated before."""
    for name in ("on_deactivate", "on_shutdown", "on_cleanup", "on_error"):
        method = node.methods.get(name)
        if method is not None:
            yield from _dropped(syntax, node, method)


def _dropped(syntax: Syntax, node: NodeClass, method: Function) -> Iterator[PublishAfterDeactivate]:
    """The first message of a transition that comes after a deactivation, when there is one."""
    first: ast.stmt | None = None
    for statement in method.node.body:
        sent = [each.endpoint for each in sendings(syntax, [statement], node)]
        silent = [each for each in sent if each.lifecycle and first is not None and _covers(first, each)]
        if first is not None and silent:
            yield PublishAfterDeactivate(method, first, statement, silent[0])
            return
        if first is None and any(_deactivates(call) for call in own_calls([statement])):
            if not isinstance(statement, (ast.Expr, ast.Assign)):
                return
            first = statement


def _deactivates(call: ast.Call) -> bool:
    return isinstance(call.func, ast.Attribute) and call.func.attr == "on_deactivate"


def _covers(statement: ast.stmt, endpoint: Endpoint) -> bool:
    """Whether a deactivation is of the whole node, or of this publisher."""
    for call in own_calls([statement]):
        if _deactivates(call) and isinstance(call.func, ast.Attribute):
            owner = call.func.value
            return isinstance(owner, ast.Call) or written(owner) == endpoint.attribute
    return False


def uncovered_sigterm(ending: Ending, nodes: list[NodeClass]) -> ast.Call | None:
    """``rclpy.init`` with SignalHandlerOptions.NO and no handler: SIGTERM ends the process without any Python code."""
    moving = any(commands(node) for node in nodes)
    return ending.inits[0] if moving and ending.signals == "none" and not ending.handlers else None


def fed_without_condition(syntax: Syntax, node: NodeClass) -> Iterator[tuple[ast.Call, str]]:
    """``WATCHDOG=1`` sent from a timer of a node that nothing can keep from it: the call, and the callback."""
    for callback in node.callbacks:
        method = node.methods.get(callback.name or "")
        if callback.role != "timer" or method is None:
            continue
        body = method.node.body
        if any(isinstance(each, (ast.If, ast.Try, ast.Return, ast.While, ast.Match)) for each in body):
            continue
        for call in own_calls(body):
            words = [each.value for each in walk(call) if isinstance(each, ast.Constant)]
            if any(isinstance(word, (str, bytes)) and "WATCHDOG=1" in str(word) for word in words):
                if published(syntax, call, node) is None and not _conditional(syntax, call):
                    yield call, str(callback.name)
                    break


def _conditional(syntax: Syntax, call: ast.Call) -> bool:
    return any(isinstance(outer, (ast.If, ast.IfExp, ast.BoolOp)) for outer, _ in syntax.within(call))
