"""Requests that a node sends although it has found that their service is not there."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.python import called_name
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

_SENDS = {
    "wait_for_service": ("call_async", "call"),
    "wait_for_server": ("send_goal_async", "send_goal"),
}
"""How a client waits for its server, and how it sends what it wants of it."""
_LEAVES = (ast.Return, ast.Raise, ast.Continue, ast.Break, ast.Assign, ast.AugAssign, ast.AnnAssign)
"""What leaves the block, or may choose something else."""
_ENDS = frozenset({"exit", "_exit", "quit", "abort", "fail", "kill", "shutdown", "try_shutdown", *_SENDS})


class SentInVain(NamedTuple):
    asked: ast.Call
    """``client.wait_for_service(timeout_sec=1.0)``, whose answer changes nothing."""
    sent: ast.Call
    kind: str
    """``request`` or ``goal``."""
    waits: bool
    """The call itself waits for the answer."""
    is_limited: bool
    """What waits for the answer behind it has a time-out, after which nothing uses an answer that is None."""


def sent_in_vain(syntax: Syntax) -> Iterator[SentInVain]:
    """What is sent behind an ``if not client.wait_for_service(...)`` that goes on, in the same block."""
    for asked in syntax.calls:
        if not isinstance(asked.func, ast.Attribute) or asked.func.attr not in _SENDS:
            continue
        condition = _negated(syntax, asked)
        if condition is None or condition.orelse or _leaves(condition):
            continue
        client, names = written(asked.func.value), _SENDS[asked.func.attr]
        later = list(_after(syntax, condition))
        at = next((number for number, each in enumerate(later) if _is_sent(each, client, names)), None)
        if at is None:
            continue
        found = later[at]
        kind = "request" if asked.func.attr == "wait_for_service" else "goal"
        is_limited = any(map(_is_limited, later[at + 1 :])) and _is_checked(syntax, found)
        yield SentInVain(asked, found, kind, called_name(found) == names[1], is_limited)


def _is_limited(call: ast.Call) -> bool:
    """Whether a call waits for an answer up to a time-out."""
    given = [*call.args, *(each.value for each in call.keywords if each.arg == "timeout_sec")]
    return called_name(call) == "spin_until_future_complete" and any(
        isinstance(each, ast.Constant) and isinstance(each.value, (int, float)) for each in given
    )


def _is_checked(syntax: Syntax, sent: ast.Call) -> bool:
    """Whether the function that sends asks whether there is an answer, or does not look at it."""
    statements = list(own(body_of(syntax.function(sent))))
    results = {
        target.id
        for each in statements
        if isinstance(each, ast.Assign) and _is_result(each.value)
        for target in each.targets
        if isinstance(target, ast.Name)
    }
    answers = [each for each in statements if _is_result(each) or getattr(each, "id", None) in results]
    asked = {id(part) for each in statements for part in _asked(each)}
    is_done = any(getattr(each, "attr", "") == "done" for each in statements)
    return not answers or is_done or any(id(each) in asked for each in answers)


def _is_result(node: ast.AST) -> bool:
    return isinstance(node, ast.Call) and called_name(node) == "result"


def _asked(node: ast.AST) -> list[ast.expr]:
    """What is taken for true or false, or compared with None."""
    if isinstance(node, ast.Compare):
        return [node.left] if any(getattr(each, "value", 0) is None for each in node.comparators) else []
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        return [node.operand]
    if isinstance(node, (ast.If, ast.IfExp)):
        return [node.test]
    return node.values if isinstance(node, ast.BoolOp) else []


def _negated(syntax: Syntax, asked: ast.Call) -> ast.If | None:
    """The statement ``if not asked:``."""
    outers = [outer for outer, _ in syntax.above(asked)][:2]
    if len(outers) < 2 or not isinstance(outers[0], ast.UnaryOp) or not isinstance(outers[0].op, ast.Not):
        return None
    return outers[1] if isinstance(outers[1], ast.If) and outers[1].test is outers[0] else None


def _leaves(condition: ast.If) -> bool:
    return any(
        isinstance(each, _LEAVES) or (isinstance(each, ast.Call) and called_name(each) in _ENDS)
        for each in own(condition.body)
    )


def _after(syntax: Syntax, condition: ast.If) -> Iterator[ast.Call]:
    """The calls that come after a statement in any case."""
    later = syntax.after(condition)
    end = next((number for number, each in enumerate(later) if hasattr(each, "body")), len(later))
    return own_calls(later[:end])


def _is_sent(call: ast.Call, client: str, names: tuple[str, str]) -> bool:
    return isinstance(call.func, ast.Attribute) and call.func.attr in names and written(call.func.value) == client
