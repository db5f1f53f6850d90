"""What goes wrong when a node is stopped: exceptions that nobody takes, shutdowns and commands that come too late."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.ending import Spin
from bringup_lint.graph.nodes.sources.ending import statements_of
from bringup_lint.graph.nodes.sources.sending import Sending
from bringup_lint.graph.nodes.sources.sending import sendings
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import PlacedNode
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

STOPS = frozenset({"KeyboardInterrupt", "ExternalShutdownException"})
"""The exceptions by which a spin ends when a signal comes."""
_TAKES_TERM = frozenset({"ExternalShutdownException", "Exception", "BaseException"})
_LEAVES = (ast.Return, ast.Raise)


class UnhandledShutdown(NamedTuple):
    """A ``try`` around a spin that takes KeyboardInterrupt alone: ``caught`` is that name."""

    caught: ast.expr
    spin: Spin


class DoubleShutdown(NamedTuple):
    """A ``rclpy.shutdown()`` behind a spin that the signal has ended together with the context."""

    call: ast.Call
    spin: Spin


class StopAfterShutdown(NamedTuple):
    """A message that is published when the context is invalid. ``how``: ``raises``, ``caught`` (the exception is
    taken), ``skipped`` (a condition on ``rclpy.ok()`` is false) or ``registered`` (at exit, or on shutdown)."""

    sending: Sending
    how: str
    place: PlacedNode
    spin: Spin | None


def default_signals(ending: Ending) -> bool:
    """Whether rclpy alone handles SIGINT and SIGTERM."""
    return ending.signals == "rclpy" and not ending.handlers


def blocks_after_spin(ending: Ending, node: ast.Try) -> list[list[ast.stmt]]:
    """The blocks that run when a signal has ended the spin in a ``try``."""
    taken = [handler for handler in node.handlers if ending.caught(handler) & (STOPS | {"BaseException", "Exception"})]
    blocks = [handler.body for handler in taken if ending.caught(handler) & STOPS]
    blocks.append(node.finalbody)
    quiet = [handler for handler in taken if "KeyboardInterrupt" in ending.caught(handler)]
    if quiet and not any(isinstance(last, _LEAVES) or _exits(ending, last) for each in quiet for last in each.body):
        blocks.append(ending.syntax.after(node))
    return [block for block in blocks if block]


def _exits(ending: Ending, statement: ast.stmt) -> bool:
    calls = [node for node in ast.walk(statement) if isinstance(node, ast.Call)]
    return any(ending.syntax.qualified(call) in ("sys.exit", "os._exit") for call in calls)


def unhandled_shutdown(ending: Ending) -> Iterator[UnhandledShutdown]:
    """Spins whose ExternalShutdownException passes every ``except`` around them."""
    if not default_signals(ending):
        return
    for node, spins in ending.tries:
        single = next((spin for spin in spins if spin.executor == "single"), None)
        names = [ending.caught(handler) for handler in node.handlers]
        if single is None or frozenset() in names or any(each & _TAKES_TERM for each in names):
            continue
        for handler in node.handlers:
            if "KeyboardInterrupt" in ending.caught(handler) and not _taken_outside(ending, node):
                named = [
                    each for each in _types(handler) if ending.file.span_of(each).text.endswith("KeyboardInterrupt")
                ]
                yield from (UnhandledShutdown(each, single) for each in named[:1])


def _types(handler: ast.ExceptHandler) -> list[ast.expr]:
    """The exceptions that a handler names."""
    if handler.type is None:
        return []
    return handler.type.elts if isinstance(handler.type, ast.Tuple) else [handler.type]


def _taken_outside(ending: Ending, node: ast.AST) -> bool:
    """Whether an outer ``try``, here or around a call of this function, takes the exception."""
    if _taken(ending, node):
        return True
    function = ending.syntax.function(node)
    if function is None:
        return False
    return any(
        isinstance(call.func, (ast.Name, ast.Attribute)) and _last(call.func) == function.name and _taken(ending, call)
        for call in ending.syntax.calls
    )


def _last(node: ast.Name | ast.Attribute) -> str:
    return node.id if isinstance(node, ast.Name) else node.attr


def _taken(ending: Ending, node: ast.AST) -> bool:
    for outer, name in ending.syntax.within(node):
        if isinstance(outer, ast.Try) and name == "body":
            names = [ending.caught(handler) for handler in outer.handlers]
            if frozenset() in names or any(each & _TAKES_TERM for each in names):
                return True
        if isinstance(outer, ast.With):
            return True
    return False


def double_shutdown(ending: Ending) -> Iterator[DoubleShutdown]:
    """Every ``rclpy.shutdown()`` that is reached and finds the context shut down already."""
    if not default_signals(ending):
        return
    seen: set[ast.AST] = set()
    for node, spins in ending.tries:
        for block in blocks_after_spin(ending, node):
            end = _raises_at(ending, block)
            for call in own_calls(block):
                plain = ending.syntax.qualified(call) == "rclpy.shutdown" and not call.args and not call.keywords
                reached = end is None or ending.file.span_of(call).start < end
                if plain and reached and call not in seen and not _guarded(ending, call, block):
                    seen.add(call)
                    yield DoubleShutdown(call, spins[0])


def _raises_at(ending: Ending, block: list[ast.stmt]) -> int | None:
    """Where a block publishes first, which raises an exception; None when it does not."""
    raising = (each.call for each in sendings(ending.syntax, block) if _how(ending, each.call, block) == "raises")
    return min((ending.file.span_of(call).start for call in raising), default=None)


def _guarded(ending: Ending, call: ast.AST, block: list[ast.stmt]) -> bool:
    """Whether a condition, ``with`` or ``try`` is between a block and a call in it."""
    outer = next(ending.syntax.above(block[0]))[0]
    return ending.guarded(call, outer)


def stop_after_shutdown(ending: Ending) -> Iterator[StopAfterShutdown]:
    """The messages that are published behind a spin which a signal has ended."""
    if ending.signals == "rclpy" and not ending.handlers:
        seen: set[ast.AST] = set()
        for node, spins in ending.tries:
            for block in blocks_after_spin(ending, node):
                for sending in sendings(ending.syntax, block):
                    if sending.call not in seen:
                        seen.add(sending.call)
                        yield StopAfterShutdown(sending, _how(ending, sending.call, block), sending.call, spins[0])
    yield from _registered(ending)


def _how(ending: Ending, call: ast.Call, block: list[ast.stmt]) -> str:
    outer = next(ending.syntax.above(block[0]))[0]
    for above, name in ending.syntax.within(call):
        if above is outer:
            break
        if isinstance(above, (ast.If, ast.While, ast.IfExp, ast.BoolOp)):
            return "skipped" if "ok()" in written(getattr(above, "test", above)) else "perhaps"
        if isinstance(above, ast.With) or (isinstance(above, ast.Try) and name == "body" and above.handlers):
            return "caught"
    return "raises"


def _registered(ending: Ending) -> Iterator[StopAfterShutdown]:
    """Functions that publish, given to ``context.on_shutdown``; to ``atexit`` when rclpy handles the signals."""
    for call in ending.syntax.calls:
        if not call.args:
            continue
        on_shutdown = is_on_shutdown(call)
        if not on_shutdown and (ending.syntax.qualified(call) != "atexit.register" or not default_signals(ending)):
            continue
        cls = ending.syntax.class_of(call)
        for sending in sendings(ending.syntax, statements_of(ending, call.args[0], cls), cls):
            yield StopAfterShutdown(sending, "on-shutdown" if on_shutdown else "at-exit", call, None)


def is_on_shutdown(call: ast.Call) -> bool:
    function = call.func
    return isinstance(function, ast.Attribute) and function.attr == "on_shutdown" and _is_context(function.value)


def _is_context(node: ast.expr) -> bool:
    node = node.func if isinstance(node, ast.Call) else node
    return isinstance(node, (ast.Name, ast.Attribute)) and "context" in _last(node).lower()


class HandlerNeverRuns(NamedTuple):
    """A signal handler of Python that a waiting spin keeps from running.

    ``place``: ``signal.signal(...)``, or the option that leaves the signals to Python."""

    place: PlacedNode
    signals: frozenset[str]
    spin: Spin
    wakers: list[Callback]
    """What wakes the node now and then: its subscriptions and services."""


def handler_never_runs(ending: Ending, nodes: list[NodeClass]) -> Iterator[HandlerNeverRuns]:
    """``nodes``: all that the program makes, none of them with a timer."""
    direct = [spin for spin in ending.spins if not spin.loop]
    if not direct or len(direct) < len(ending.spins) or ending.signals is None:
        return
    wakers = [callback for node in nodes for each in node.lineage for callback in each.callbacks]
    shown = False
    for handler in ending.handlers:
        if handler.python and (ending.signals == "none" or surely_after(ending, handler.call)):
            shown = True
            yield HandlerNeverRuns(handler.call, handler.signals, direct[0], wakers)
    if ending.signals == "none" and not shown and not ending.handlers:
        option = next(each for each in ending.inits[0].keywords if each.arg == "signal_handler_options")
        yield HandlerNeverRuns(option.value, frozenset({"SIGINT"}), direct[0], wakers)


def surely_after(ending: Ending, call: ast.Call) -> bool:
    """Whether a handler is set after ``rclpy.init``, so that it replaces the one of rclpy."""
    function = ending.syntax.function(call)
    inits = ending.inits
    if function is None or any(isinstance(outer, (ast.If, ast.While)) for outer, _ in ending.syntax.within(call)):
        return False
    if ending.syntax.class_of(call) is not None and function.name == "__init__":
        return True
    return all(ending.syntax.function(init) is function and init.lineno < call.lineno for init in inits)
