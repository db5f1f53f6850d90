"""Loops of callbacks that wait for a value which only another callback of the node changes, or nothing at all."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.callback_code import code_of
from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.endless_loops import has_no_exit
from bringup_lint.graph.nodes.sources.endless_loops import spins
from bringup_lint.graph.nodes.sources.stored_values import is_message
from bringup_lint.graph.nodes.sources.stored_values import stored
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import Group
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import is_own
from bringup_lint.model.python import is_self
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

_PARTS = (
    *(ast.Name, ast.Attribute, ast.Constant, ast.Compare, ast.BoolOp, ast.UnaryOp, ast.BinOp, ast.Call),
    *(ast.expr_context, ast.cmpop, ast.boolop, ast.unaryop, ast.operator),
)
"""What a condition may be made of that is understood."""
_ASKS = ("is_set", "done")
"""Methods of an event and of a future."""
_ANSWERS = ("call_async", "send_goal_async", "get_result_async", "cancel_goal_async")


class Awaited(NamedTuple):
    """What ends a wait: one of some callbacks, the answer to a client, or nothing at all."""

    by: tuple[Callback, ...]
    group: Group | None = None
    """The group of the client."""
    is_answer: bool = False


def awaited(ending: Ending, loop: ast.While, cls: NodeClass) -> Awaited | None:
    """Who could end a loop that has no other exit, when that is known."""
    if not has_no_exit(loop) or spins(loop) or not all(isinstance(each, _PARTS) for each in walk(loop.test)):
        return None
    if cls.node is None or "Thread" in ending.file.source.text:
        return None
    answer = _answer(ending, loop, cls)
    if answer is not None:
        return answer
    calls = [each for each in walk(loop.test) if isinstance(each, ast.Call) and not _is_ok(ending, each)]
    if any(not _is_event(each) for each in calls):
        return None
    if not all(_is_of_node(ending, cls, each) for each in walk(loop.test) if isinstance(each, ast.Attribute)):
        return None
    attributes = {each.attr for each in walk(loop.test) if is_own(each)}
    names = {each.id for each in walk(loop.test) if isinstance(each, ast.Name)} - {"self"}
    if not names <= _constant_names(ending, loop, cls) or not _is_untouched(ending, loop, cls, attributes, names):
        return None
    return _setters(ending, cls, attributes, bool(calls))


def _answer(ending: Ending, loop: ast.While, cls: NodeClass) -> Awaited | None:
    """``while not future.done()`` for what a client was asked in the same function."""
    test = loop.test.operand if isinstance(loop.test, ast.UnaryOp) and isinstance(loop.test.op, ast.Not) else None
    if not isinstance(test, ast.Call) or not isinstance(test.func, ast.Attribute) or test.func.attr != "done":
        return None
    future, function = written(test.func.value), ending.syntax.function(loop)
    if function is None:
        return None
    made = [
        each.value
        for each in walk(function)
        if isinstance(each, ast.Assign) and any(written(target) == future for target in each.targets)
    ]
    call = made[0] if len(made) == 1 else None
    if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Attribute) or call.func.attr not in _ANSWERS:
        return None
    client = _client(cls, written(call.func.value))
    return Awaited((), client.callback_group, True) if client is not None else None


def _client(cls: NodeClass, kept: str) -> Endpoint | None:
    return next((each for each in cls.all_endpoints if each.role.endswith("client") and each.attribute == kept), None)


def _constant_names(ending: Ending, loop: ast.While, cls: NodeClass) -> set[str]:
    """The names that surely mean the same in each turn: the message, imports, and what the module sets once."""
    function = ending.syntax.function(loop)
    taken = {each.callback for each in cls.endpoints if each.role == "subscription"}
    if function is None or ending.file.tree is None:
        return set()
    arguments = function.args.args[1:2] if function.name in taken else []
    made = [target for each in ending.file.tree.body if isinstance(each, ast.Assign) for target in each.targets]
    changed = {name for each in ending.file.nodes if isinstance(each, ast.Global) for name in each.names}
    constants = {each.id for each in made if isinstance(each, ast.Name)} - changed
    bound = {each.id for each in walk(function) if isinstance(each, ast.Name) and not isinstance(each.ctx, ast.Load)}
    return ({each.arg for each in arguments} | constants | ending.file.imports.keys()) - bound


def _is_of_node(ending: Ending, cls: NodeClass, node: ast.Attribute) -> bool:
    """Whether what an attribute means changes in this file alone: an object of another class may change by itself."""
    if not is_own(node.value):
        return True
    values = stored(ending.syntax, cls, node.value)
    if node.attr in _ASKS:
        return bool(values) and all(_is_waited_for(ending, each) for each in values)
    return bool(values) and all(is_message(ending.syntax, cls, each) for each in values)


def _is_waited_for(ending: Ending, value: ast.expr | None) -> bool:
    """Whether a value is an event or a future."""
    name = ending.syntax.qualified(value) or written(value.func) if isinstance(value, ast.Call) else ""
    return name.rpartition(".")[2] in ("Event", "Future", *_ANSWERS)


def _is_event(call: ast.Call) -> bool:
    function = call.func
    return isinstance(function, ast.Attribute) and function.attr in _ASKS and is_own(function.value)


def _is_ok(ending: Ending, call: ast.Call) -> bool:
    return ending.syntax.qualified(call) == "rclpy.ok"


def _is_untouched(ending: Ending, loop: ast.While, cls: NodeClass, attributes: set[str], names: set[str]) -> bool:
    """Whether nothing in a loop can change what its condition looks at."""
    for node in reached(ending.syntax, list(loop.body), cls):
        if isinstance(node, ast.Name) and node.id in names and not _is_read(ending, node):
            return False
        if is_own(node) and node.attr in attributes:
            if not _is_read(ending, node):
                return False
        if is_self(node) and not isinstance(next(ending.syntax.above(node))[0], ast.Attribute):
            return False
        if isinstance(node, ast.Call) and _is_unknown_method(node, cls):
            return False
    return True


def _is_read(ending: Ending, node: ast.Name | ast.Attribute) -> bool:
    """Whether a place only reads a value: it is no target, no argument, and no method of it is called."""
    if not isinstance(node.ctx, ast.Load):
        return False
    inner: ast.AST = node
    for outer, name in ending.syntax.above(node):
        if isinstance(outer, ast.stmt):
            return True
        if isinstance(outer, ast.Call) and (name == "func" or inner is node):
            return False
        if isinstance(outer, (ast.Attribute, ast.Subscript)) and not isinstance(outer.ctx, ast.Load):
            return False
        inner = outer
    return True


def _is_unknown_method(call: ast.Call, cls: NodeClass) -> bool:
    """Whether a call is one of a method of the class which is not in its source, so that it may do anything."""
    function = call.func
    if not is_own(function):
        return False
    return function.attr not in cls.methods and function.attr not in ("get_logger", "get_clock", "get_name")


def _setters(ending: Ending, cls: NodeClass, attributes: set[str], is_event: bool) -> Awaited | None:
    """The callbacks that change an attribute; nothing when other code does, or that is not known."""
    if attributes & cls.methods.keys() or _is_known_elsewhere(ending, cls, attributes):
        return None
    roles: dict[ast.AST, Callback] = {}
    for callback in cls.callbacks:
        for node in reached(ending.syntax, code_of(ending, cls, callback)[1], cls):
            roles.setdefault(node, callback)
    init = cls.methods.get("__init__")
    at_start = set(reached(ending.syntax, body_of(init.node), cls)) if init is not None else set()
    found: dict[Callback, None] = {}
    for place in _changes(ending, attributes, is_event):
        if place in roles:
            found[roles[place]] = None
        elif place not in at_start:
            return None
    return Awaited(tuple(found))


def _is_known_elsewhere(ending: Ending, cls: NodeClass, attributes: set[str]) -> bool:
    """Whether a class of another file that this one builds on has one of the attributes."""
    others = [each.source.text for each in cls.lineage if each.source is not ending.file.source]
    return any(name in text for name in attributes for text in others)


def _changes(ending: Ending, attributes: set[str], is_event: bool) -> Iterator[ast.AST]:
    """The places of the file that may change one of the attributes."""
    for node in ending.file.nodes:
        if not isinstance(node, ast.Attribute):
            continue
        if node.attr in attributes and not _is_read(ending, node) and not _asks(ending, node):
            yield node
        elif is_event and node.attr in ("set", "set_result") and not is_own(node.value):
            yield node


def _asks(ending: Ending, node: ast.Attribute) -> bool:
    """Whether a method of an event is called that changes nothing."""
    outer = next(ending.syntax.above(node))[0]
    return isinstance(outer, ast.Attribute) and outer.attr in (*_ASKS, "wait")
