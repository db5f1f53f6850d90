"""Attributes of nodes that only a message sets, and that other callbacks use without asking whether it came."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.python.missing_attributes import CAUGHT
from bringup_lint.graph.nodes.questions.python.missing_attributes import family_of
from bringup_lint.graph.nodes.questions.python.missing_attributes import heirs_of
from bringup_lint.graph.nodes.questions.python.missing_attributes import own_uses
from bringup_lint.graph.nodes.questions.python.missing_attributes import set_in_body
from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import Callback
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import Timer
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_self
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_BRANCHES = (ast.If, ast.IfExp, ast.While, ast.For, ast.AsyncFor, ast.BoolOp, ast.Try, ast.Match, *FUNCTIONS)
"""What is in them may not run, or only when something else has been asked."""
_LEAVES = (ast.Return, ast.Raise, ast.Yield, ast.YieldFrom, ast.Await, ast.Assert, ast.While)
_RECEIVES = frozenset({"spin_once", "spin_until_future_complete", "wait_for_message"})
"""Calls by which a constructor may wait for the message itself."""


class LateAttribute(NamedTuple):
    """A use of ``self.x`` that raises until a message has come."""

    file: NodeSource
    place: ast.Attribute
    user: Callback
    setter: Callback
    set_at: ast.Attribute


def late_attributes(nodes: Nodes) -> Iterator[list[LateAttribute]]:
    """Those of one method together, the first use of each attribute."""
    foreign = nodes.set_elsewhere
    heirs = heirs_of(nodes)
    for file, node in nodes.node_classes:
        family = family_of(nodes, node, heirs)
        if node.node is None or family is None or len(set(family)) != 1:
            continue
        syntax = nodes.syntax(file)
        setters = _set_by_messages(syntax, node, foreign)
        if not setters:
            continue
        for user in _users(node):
            found = list(_used(file, syntax, node, user, setters))
            if found:
                yield found


def _set_by_messages(syntax: Syntax, node: NodeClass, foreign: set[str]) -> dict[str, tuple[Callback, ast.Attribute]]:
    """Attribute -> the one subscription that sets it, and where, for those that nothing else sets."""
    by_name = {each.name: each for each in node.callbacks if each.role == "subscription" and each.name is not None}
    given = {each.name for each in node.callbacks if each.role != "subscription"}
    texts = {each.value for each in syntax.file.nodes if isinstance(each, ast.Constant)}
    found: dict[str, tuple[Callback, ast.Attribute]] = {}
    spoilt: set[str] = set(foreign)
    for place in _stores(node):
        function = _outermost(syntax, place)
        setter = by_name.get(function.name) if function is not None and function.name not in given else None
        if setter is None or not _is_plain_store(syntax, place) or place.attr in texts:
            spoilt.add(place.attr)
        elif place.attr in found and found[place.attr][0] is not setter:
            spoilt.add(place.attr)
        else:
            found.setdefault(place.attr, (setter, place))
    called = {each.func.attr for each in syntax.calls if isinstance(each.func, ast.Attribute)}
    spoilt.update(set_in_body(node.node) if node.node is not None else ())
    return {name: each for name, each in found.items() if name not in spoilt and each[0].name not in called}


def _stores(node: NodeClass) -> Iterator[ast.Attribute]:
    for each in node.inner:
        if isinstance(each, ast.Attribute) and not isinstance(each.ctx, ast.Load):
            yield each


def _is_plain_store(syntax: Syntax, place: ast.Attribute) -> bool:
    outer = next((outer for outer, _ in syntax.above(place)), None)
    return not isinstance(outer, ast.AugAssign) and is_self(place.value)


def _outermost(syntax: Syntax, place: ast.AST) -> FunctionNode | None:
    """The method that a place is in."""
    found = None
    for outer, _ in syntax.above(place):
        if isinstance(outer, (ast.FunctionDef, ast.AsyncFunctionDef)):
            found = outer
    return found


def _users(node: NodeClass) -> Iterator[Callback]:
    """The callbacks that run whether or not another message has come, made once in the constructor."""
    first_calls = _called_at_start(node)
    if first_calls & _RECEIVES:
        return
    certain = [each.span for each in node.endpoints if not each.conditional and each.method == "__init__"]
    if "cancel" not in first_calls:
        certain += [each.span for each in node.timers if _is_started(each)]
    seen = set()
    for callback in node.callbacks:
        made = any(span.start <= callback.span.start and callback.span.end <= span.end for span in certain)
        if callback.role in ("timer", "subscription") and made and callback.name not in seen:
            seen.add(callback.name)
            yield callback


def _called_at_start(node: NodeClass) -> set[str]:
    """The last names of what the constructor calls."""
    constructor = node.methods.get("__init__")
    if constructor is None:
        return set()
    return {called_name(each) for each in walk(constructor.node) if isinstance(each, ast.Call)}


def _is_started(timer: Timer) -> bool:
    """Whether a timer runs from the start, and not when something resets it."""
    return not timer.conditional and timer.method == "__init__" and "autostart" not in timer.span.text


def _used(
    file: NodeSource,
    syntax: Syntax,
    node: NodeClass,
    user: Callback,
    setters: dict[str, tuple[Callback, ast.Attribute]],
) -> Iterator[LateAttribute]:
    method = node.methods.get(user.name) if user.name is not None else None
    if method is None or user.span.text != f"self.{user.name}":
        return
    seen = set()
    for place in sorted(own_uses(syntax, node), key=lambda each: (each.lineno, each.col_offset)):
        if place.attr not in setters or place.attr in seen or syntax.function(place) is not method.node:
            continue
        setter, set_at = setters[place.attr]
        if setter.name != user.name and is_certain(syntax, method.node, place):
            seen.add(place.attr)
            yield LateAttribute(file, place, user, setter, set_at)


def is_certain(syntax: Syntax, method: ast.AST, place: ast.Attribute) -> bool:
    """Whether a place runs each time that its method does, and nothing takes the exception."""
    if syntax.catches(place, CAUGHT) or syntax.is_dead(place):
        return False
    inner: ast.AST = place
    for outer, name in syntax.above(place):
        if outer is method:
            break
        is_first = name in ("test", "iter") or (isinstance(outer, ast.BoolOp) and outer.values[0] is inner)
        if isinstance(outer, _BRANCHES) and not is_first:
            return False
        inner = outer
    before = (each for each in walk(method) if getattr(each, "lineno", place.lineno) < place.lineno)
    return not any(isinstance(each, _LEAVES) for each in before)
