"""Whether code publishes: directly, or through the methods and functions of its file."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import is_self
from bringup_lint.named_tuple import NamedTuple

DEPTH = 5
STEPS = 400
"""Functions that are looked into from one place."""


class Sending(NamedTuple):
    """``call`` leads to ``publish`` (it may be the same), which sends on ``endpoint``."""

    call: ast.Call
    publish: ast.Call
    endpoint: Endpoint


def sendings(syntax: Syntax, nodes: Iterable[ast.AST], cls: NodeClass | None = None) -> Iterator[Sending]:
    """What the statements publish on publishers of the file. ``cls``: the class that ``self`` is of."""
    seen: set[ast.AST] = set()
    for call in own_calls(nodes):
        for publish, endpoint in _leads_to(syntax, call, cls, DEPTH, seen):
            yield Sending(call, publish, endpoint)


def _leads_to(
    syntax: Syntax, call: ast.Call, cls: NodeClass | None, depth: int, seen: set[ast.AST]
) -> Iterator[tuple[ast.Call, Endpoint]]:
    endpoint = published(syntax, call, cls)
    if endpoint is not None:
        yield call, endpoint
        return
    for function, owner in called(syntax, call, cls):
        if depth and function not in seen and len(seen) < STEPS:
            seen.add(function)
            for inner in own_calls(body_of(function)):
                yield from _leads_to(syntax, inner, owner, depth - 1, seen)


def published(syntax: Syntax, call: ast.Call, cls: NodeClass | None) -> Endpoint | None:
    """The publisher whose ``publish`` is called."""
    function = call.func
    if not isinstance(function, ast.Attribute) or function.attr != "publish":
        return None
    kept = function.value
    if isinstance(kept, ast.Attribute) and isinstance(kept.value, ast.Name):
        owners = [cls] if cls is not None and kept.value.id == "self" else syntax.file.classes
        return _publisher((each for owner in owners for each in owner.all_endpoints), f"self.{kept.attr}")
    if isinstance(kept, ast.Name):
        every = (*(each for owner in syntax.file.classes for each in owner.endpoints), *syntax.file.strays)
        return _publisher(every, kept.id)
    return None


def _publisher(endpoints: Iterable[Endpoint], kept: str) -> Endpoint | None:
    return next((each for each in endpoints if each.role == "publisher" and each.attribute == kept), None)


def called(syntax: Syntax, call: ast.Call, cls: NodeClass | None) -> Iterator[tuple[FunctionNode, NodeClass | None]]:
    """The functions and methods of the file that a call may run."""
    function, file = call.func, syntax.file
    if isinstance(function, ast.Name):
        if function.id in file.functions:
            yield file.functions[function.id].node, None
        return
    if not isinstance(function, ast.Attribute):
        return
    for owner in _owners(syntax, call, function.value, cls):
        method = owner.method(function.attr)
        if method is not None:
            yield method.node, owner
            return


def _owners(syntax: Syntax, call: ast.Call, node: ast.expr, cls: NodeClass | None) -> list[NodeClass]:
    """The classes that an expression may be an instance of."""
    file: NodeSource = syntax.file
    if is_self(node) and cls is not None:
        return [cls]
    if isinstance(node, ast.Call):
        return [cls.base] if cls is not None and cls.base is not None and _is_super(node) else []
    name = file.named(node, syntax.function(call))
    if name is not None:
        return [each for each in file.classes if each.name == name]
    last = node.id if isinstance(node, ast.Name) else getattr(node, "attr", "")
    unsure = isinstance(node, ast.Name) or "node" in last.lower()
    return [each for each in file.classes if each.is_node] if unsure and last not in file.imports else []


def _is_super(node: ast.Call) -> bool:
    return isinstance(node.func, ast.Name) and node.func.id == "super"
