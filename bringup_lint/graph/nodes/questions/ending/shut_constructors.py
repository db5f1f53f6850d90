"""Constructors of nodes that shut the context down and then go on with it."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.failure_logs import is_said
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_own
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

_SHUTDOWNS = frozenset({"rclpy.shutdown", "rclpy.try_shutdown"})
_MAKES = frozenset(
    {"create_publisher", "create_subscription", "create_service", "create_client", "create_timer", "create_rate"}
)
_ASKS = frozenset({"ok", "exit", "is_shutdown"})
_CAUGHT = frozenset({"Exception", "BaseException", "RuntimeError", "RCLError"})
_LEAVES = (ast.Return, ast.Raise)
_EXITS = frozenset({"exit", "quit", "_exit", "kill", "abort"})
_QUIET = frozenset(
    {"shutdown", "try_shutdown", "get_logger", "debug", "destroy_node", "close", "release", "str", "format"}
)
"""Calls that surely log nothing of a failure."""


class ShutConstructor(NamedTuple):
    shutdown: ast.Call
    made: ast.Call
    """What raises, because the context is shut down."""
    name: str
    is_logged: bool | None
    """The branch has logged what failed, so that the log has the cause as well; None where that is not known."""


def shut_constructors(syntax: Syntax, node: NodeClass) -> Iterator[ShutConstructor]:
    """The first of them in a class."""
    init = node.methods.get("__init__")
    calls = own_calls(body_of(init.node)) if init is not None else ()
    for call in calls:
        if syntax.qualified(call) in _SHUTDOWNS:
            made = next(_made_after(syntax, call), None)
            if made is not None:
                yield ShutConstructor(call, made, written(made.func), _is_logged(syntax, node, call))
                return


def spun_after(syntax: Syntax, node: NodeClass) -> Iterator[ShutConstructor]:
    """The first shutdown of a constructor that returns after it, with the ``rclpy.spin`` of a function which makes the
    node and spins it without a question."""
    init = node.methods.get("__init__")
    calls = own_calls(body_of(init.node)) if init is not None and node.name is not None else ()
    shutdowns = [each for each in calls if syntax.qualified(each) in _SHUTDOWNS and _returns_after(syntax, each)]
    if not shutdowns:
        return
    for spin in syntax.named.get("rclpy.spin", []):
        function = syntax.function(spin)
        if function is not None and len(spin.args) == 1 and _is_made_in(function, spin.args[0], str(node.name)):
            asked = {called_name(each) for each in own_calls(function.body)} & _ASKS
            if not asked and not syntax.is_dead(spin) and not syntax.catches(spin, _CAUGHT):
                yield ShutConstructor(shutdowns[0], spin, "rclpy.spin", _is_logged(syntax, node, shutdowns[0]))
                return


def _is_logged(syntax: Syntax, node: NodeClass, call: ast.Call) -> bool | None:
    """Whether the block of a call, or a handler around it, logs anything; None where it calls what is not known."""
    statement = next(outer for outer, _ in syntax.within(call) if isinstance(outer, ast.stmt))
    outers = list(syntax.above(statement))
    blocks = [getattr(outer, field) for at, (outer, field) in enumerate(outers) if at == 0 or _is_handler(outer)]
    calls = [each for block in blocks for each in own_calls(block)]
    methods = [node.methods[each.func.attr] for each in calls if is_own(each.func) and each.func.attr in node.methods]
    if any(map(is_said, (*calls, *(each for method in methods for each in own_calls(method.node.body))))):
        return True
    return False if all(called_name(each) in _QUIET for each in calls) else None


def _is_handler(outer: ast.AST) -> bool:
    return isinstance(outer, ast.ExceptHandler)


def _returns_after(syntax: Syntax, call: ast.Call) -> bool:
    """Whether the constructor returns right after a call."""
    statement = next((outer for outer, _ in syntax.within(call) if isinstance(outer, ast.stmt)), None)
    following = syntax.after(statement) if statement is not None else []
    return len(following) == 1 and isinstance(following[0], ast.Return)


def _is_made_in(function: FunctionNode, given: ast.expr, name: str) -> bool:
    """Whether what is given is a new object of a class, or a variable to which the function assigns one, and nothing
    else."""
    if not isinstance(given, ast.Name):
        return isinstance(given, ast.Call) and called_name(given) == name
    values = [
        each.value
        for each in own(function.body)
        if isinstance(each, ast.Assign) and any(isinstance(to, ast.Name) and to.id == given.id for to in each.targets)
    ]
    return len(values) == 1 and isinstance(values[0], ast.Call) and called_name(values[0]) == name


def _made_after(syntax: Syntax, call: ast.Call) -> Iterator[ast.Call]:
    """What the constructor surely makes after a call, unless it leaves before."""
    outers = [outer for outer, _ in syntax.within(call) if isinstance(outer, ast.stmt)]
    unset = {name for outer in outers if isinstance(outer, ast.Try) for name in _attributes(outer.body, ast.Store)}
    for following in (each for outer in outers for each in syntax.after(outer)):
        if _may_leave(following) or not unset.isdisjoint(_attributes([following], ast.Load)):
            return
        if isinstance(following, (ast.Expr, ast.Assign, ast.AnnAssign)):
            yield from (each for each in own_calls([following]) if _makes(each))


def _attributes(statements: list[ast.stmt], context: type[ast.expr_context]) -> Iterator[str]:
    """The attributes of ``self`` that statements set, or read: what a ``try`` failed to set raises sooner."""
    for each in own(statements):
        if is_own(each) and isinstance(each.ctx, context):
            yield each.attr


def _may_leave(statement: ast.stmt) -> bool:
    if any(isinstance(each, _LEAVES) for each in ast.walk(statement)):
        return True
    return any(called_name(each) in _EXITS for each in own_calls([statement]))


def _makes(call: ast.Call) -> bool:
    return is_own(call.func) and call.func.attr in _MAKES
