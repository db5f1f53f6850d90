"""What the callbacks of a node wait for while an executor waits for them."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.questions.callbacks.blocking_calls import Blocked
from bringup_lint.graph.nodes.questions.callbacks.blocking_calls import blocked
from bringup_lint.graph.nodes.sources.callback_code import reached_once
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import Group
from bringup_lint.model.node_source import NodeClass
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span


class Blocking(NamedTuple):
    """A call in a callback that gives the executor nothing back for a while."""

    callback: Callback
    name: str
    """The method or function that is the callback."""
    call: ast.Call | ast.While
    what: str
    how_long: str
    """As in ``Blocked``."""
    partner: Group | None = None
    """The group of the callback that it waits for."""
    nested: bool = False
    """It runs the executor itself, so that only a shared group keeps its partner from running."""
    inner: str = ""
    """What blocks in the method of another class that is called here: ``requests.post``."""
    where: Span | None = None
    """The place of that."""
    made: ast.expr | None = None
    """As in ``Blocked``."""


def deadlocks(found: Blocking, threads: str) -> bool:
    """Whether what a call waits for can surely never run, as tried with rclpy (Jazzy)."""
    ours, theirs = found.callback.group, found.partner
    if found.what.endswith(".sleep()"):
        return threads == "one"
    shared = ours == theirs and (ours is None or ours.reentrant is False)
    return shared if found.nested or threads != "one" else True


def blocking(ending: Ending, cls: NodeClass) -> Iterator[Blocking]:
    """The calls that block in the callbacks of a class."""
    seen: set[ast.AST] = set()
    told: set[tuple[str, str]] = set()
    callbacks = [each for each in cls.callbacks if each.role != "shutdown"]
    for callback, name, node in reached_once(ending, cls, callbacks):
        if node in seen or not isinstance(node, (ast.Call, ast.While)):
            continue
        waits = blocked(ending, node, cls)
        if waits is None:
            continue
        seen.update(ast.walk(node) if isinstance(node, ast.While) else (node,))
        found = _in_callback(cls, callback, name, node, waits)
        if found is not None and ((name, waits.what) not in told or waits.how_long):
            told.add((name, waits.what))
            yield found


def _in_callback(
    cls: NodeClass, callback: Callback, name: str, node: ast.Call | ast.While, waits: Blocked
) -> Blocking | None:
    """None for a spin in a node whose clients all have groups of their own, so that their answers come in."""
    clients = [each for each in cls.all_endpoints if each.role.endswith("client")]
    nested = waits.what.startswith("rclpy.spin")
    if nested and not any(each.callback_group is None for each in clients):
        return None
    asked = next((each for each in clients if waits.what == f"{each.attribute}.call()"), None)
    partner = asked.callback_group if asked is not None else None
    if waits.awaited is not None:
        others = [each for each in waits.awaited.by if each.name != callback.name]
        if waits.awaited.by and not others:
            return None
        groups = [waits.awaited.group] if waits.awaited.is_answer else [each.group for each in others]
        partner = next((each for each in groups if each != callback.group), callback.group)
    return Blocking(callback, name, node, waits.what, waits.how_long, partner, nested, made=waits.made)
