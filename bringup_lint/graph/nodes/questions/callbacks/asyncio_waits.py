"""Callbacks that wait for a loop of asyncio, which rclpy does not run."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.callback_code import reached_once
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import NodeClass

_NEED_A_LOOP = frozenset(
    f"asyncio.{name}" for name in ("sleep", "gather", "wait", "wait_for", "to_thread", "create_task")
)
_LOOPS = frozenset(
    f"asyncio.{name}"
    for name in ("run", "get_event_loop", "new_event_loop", "set_event_loop", "Runner", "ensure_future")
)


def awaits_asyncio(ending: Ending, cls: NodeClass) -> Iterator[tuple[Callback, str, ast.Call, str]]:
    """``await asyncio.sleep(...)`` and the like in callbacks: callback, its name, the call, the function's name."""
    if not _LOOPS.isdisjoint(ending.syntax.named):
        return
    seen: set[ast.AST] = set()
    for callback, name, node in reached_once(ending, cls, cls.callbacks):
        if not isinstance(node, ast.Await) or not isinstance(node.value, ast.Call) or node in seen:
            continue
        wanted = ending.syntax.qualified(node.value) or ""
        if wanted in _NEED_A_LOOP and not _is_zero(node.value):
            seen.add(node)
            yield callback, name, node.value, wanted


def _is_zero(call: ast.Call) -> bool:
    return bool(call.args) and isinstance(call.args[0], ast.Constant) and call.args[0].value == 0
