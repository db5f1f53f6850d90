"""What a callback keeps of its messages, and the timers and threads that go on with it."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import is_own
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

DEPTH = 3
_PASSIVE = ("subscription", "service", "parameters", "action-step")
"""Callbacks that run only when somebody sends something."""
_THREADS = ("threading.Thread", "threading.Timer")


class Loop(NamedTuple):
    """What a node runs again and again by itself."""

    name: str
    """The method."""
    span: Span
    """The timer or thread."""
    code: list[ast.AST]


def loops(syntax: Syntax, node: NodeClass) -> Iterator[Loop]:
    """The callbacks of timers, and the methods that threads run, each with all that it calls."""
    for timer in node.timers:
        method = node.methods.get(timer.callback or "")
        if method is not None:
            yield Loop(str(method.name), timer.span, reached(syntax, body_of(method.node), node))
    for name in _THREADS:
        for call in syntax.named.get(name, []):
            target = next((each.value for each in call.keywords if each.arg == "target"), None)
            method = node.methods.get(_own_attribute(target) or "")
            if method is not None:
                yield Loop(str(method.name), syntax.file.span_of(call), reached(syntax, body_of(method.node), node))


def _own_attribute(node: ast.AST | None) -> str | None:
    """``x`` of ``self.x``."""
    if is_own(node):
        return node.attr
    return None


def held_over(syntax: Syntax, node: NodeClass, callback: str | None, loop: Loop) -> set[str]:
    """The attributes that a callback fills from its message and that a loop uses, when nothing but messages changes
    them. Empty when the loop sets what the callback sets: it counts, or sends each message once. Fields of what is
    kept may be set."""
    method = node.methods.get(callback or "")
    if method is None or len(method.node.args.args) < 2:
        return set()
    every = _assigned(reached(syntax, body_of(method.node), node))
    filled = set(_filled(node, method.node, {method.node.args.args[1].arg}, {}, DEPTH))
    changed = every & _assigned(loop.code)
    if not filled or not changed <= filled or changed & _replaced(loop.code):
        return set()
    used = {each.attr for each in loop.code if isinstance(each, ast.Attribute) and _own_attribute(each)}
    return (filled & used) - changed - _assigned_elsewhere(syntax, node)


def _assigned(code: Iterator[ast.AST] | list[ast.AST]) -> set[str]:
    return {name for each in code for target in _targets(each) for name in _attributes(target)}


def _replaced(code: list[ast.AST]) -> set[str]:
    """The attributes of ``self`` that get another value as a whole, or another element."""
    parts = [part for each in code for target in _targets(each) for part in ast.walk(target)]
    whole = {each.attr for each in parts if is_own(each) and isinstance(each.ctx, ast.Store)}
    return whole | {each.value.attr for each in parts if isinstance(each, ast.Subscript) and is_own(each.value)}


def _targets(node: ast.AST) -> list[ast.expr]:
    if isinstance(node, ast.Assign):
        return node.targets
    return [node.target] if isinstance(node, (ast.AugAssign, ast.AnnAssign)) else []


def _attributes(target: ast.expr) -> Iterator[str]:
    """The attributes of ``self`` that an assignment changes, also in part: ``self.x[0]``, ``self.x.linear.x``."""
    for each in ast.walk(target):
        name = _own_attribute(each)
        if name is not None:
            yield name


def _assigned_elsewhere(syntax: Syntax, node: NodeClass) -> set[str]:
    """The attributes that other code than the constructor and the callbacks for messages and requests changes."""
    passive = [each.name for each in node.callbacks if each.role in _PASSIVE]
    known: set[ast.AST] = set()
    for name in ("__init__", *passive):
        method = node.methods.get(name or "")
        if method is not None:
            known |= {method.node, *reached(syntax, body_of(method.node), node)}
    called = {each.func.attr for each in known if isinstance(each, ast.Call) and isinstance(each.func, ast.Attribute)}
    found: set[str] = set()
    for name, each in node.methods.items():
        if each.node not in known and name not in called:
            found |= _assigned(list(own(body_of(each.node))))
    return found


def _filled(
    node: NodeClass, function: ast.AST, message: set[str], buffers: dict[str, str], depth: int
) -> Iterator[str]:
    """``message``: names whose value comes from it; ``buffers``: parameters that are attributes of the node."""
    body = body_of(function)
    for each in own(body):
        value = getattr(each, "value", None) if _targets(each) else getattr(each, "iter", None)
        if value is not None and _mentions(value, message):
            for target in _targets(each) or [each.target]:  # type: ignore[attr-defined]
                if isinstance(target, ast.Name) or isinstance(each, ast.For):
                    message |= {name.id for name in ast.walk(target) if isinstance(name, ast.Name)}
                    continue
                yield from _attributes(target)
                yield from (
                    buffers[name.id] for name in ast.walk(target) if isinstance(name, ast.Name) and name.id in buffers
                )
                if isinstance(target, ast.Tuple):
                    message |= {name.id for name in target.elts if isinstance(name, ast.Name)}
        if isinstance(each, ast.Call) and depth:
            yield from _through(node, each, message, depth)


def _mentions(value: ast.AST, names: set[str]) -> bool:
    return any(isinstance(part, ast.Name) and part.id in names for part in ast.walk(value))


def _through(node: NodeClass, call: ast.Call, message: set[str], depth: int) -> Iterator[str]:
    """What a method of the class fills with what it is handed."""
    method = node.methods.get(_own_attribute(call.func) or "")
    if method is None or call.keywords:
        return
    names = [each.arg for each in method.node.args.args][1:]
    pairs = list(zip(names, call.args))
    given = {name for name, value in pairs if _mentions(value, message)}
    buffers = {name: kept for name, value in pairs if (kept := _own_attribute(value)) is not None}
    if given:
        yield from _filled(node, method.node, given, buffers, depth - 1)
