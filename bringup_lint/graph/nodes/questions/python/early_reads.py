"""Attributes of nodes that are set only after they were used, so that the first use always raises."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts import table
from bringup_lint.graph.nodes.questions.python.missing_attributes import CAUGHT
from bringup_lint.graph.nodes.questions.python.missing_attributes import asked_for
from bringup_lint.graph.nodes.questions.python.missing_attributes import family_of
from bringup_lint.graph.nodes.questions.python.missing_attributes import heirs_of
from bringup_lint.graph.nodes.questions.python.missing_attributes import own_additions
from bringup_lint.graph.nodes.questions.python.missing_attributes import own_uses
from bringup_lint.graph.nodes.questions.python.missing_attributes import set_in_body
from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.idle import is_late
from bringup_lint.graph.nodes.sources.syntax import COMPREHENSIONS
from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import children
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from typing import TypeGuard

    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource


class EarlyRead(NamedTuple):
    """The first use of an attribute that always raises, because each assignment to it comes after such a use."""

    file: NodeSource
    place: ast.Attribute
    method: str
    set_at: ast.Attribute
    idle: bool


def early_reads(nodes: Nodes) -> Iterator[list[EarlyRead]]:
    """Those of one method together."""
    of_ros = {row["name"] for row in table("ros/node_attributes")} | set(dir(object))
    foreign = nodes.set_elsewhere
    heirs = heirs_of(nodes)
    for file, node in nodes.node_classes:
        family = family_of(nodes, node, heirs)
        if node.node is None or family is None or len(set(family)) != 1:
            continue
        known = {*of_ros, *foreign, *set_in_body(node.node), *asked_for(file)}
        groups: dict[str, list[EarlyRead]] = {}
        for found in _in_class(file, nodes.syntax(file), node, known):
            groups.setdefault(found.method, []).append(found)
        yield from groups.values()


def _in_class(file: NodeSource, syntax: Syntax, node: NodeClass, known: set[str]) -> Iterator[EarlyRead]:
    added_to = set(own_additions(syntax, node))
    stores = _by_name(each for each in node.inner if _is_store(each) and each not in added_to)
    uses = _by_name(each for each in (*own_uses(syntax, node), *added_to))
    for name, set_at in stores.items():
        places = uses.get(name, [])
        if name in known or not _may_come_after(syntax, set_at, places):
            continue
        if not all(_comes_after(syntax, each, set(places)) for each in set_at):
            continue
        first = min(places, key=lambda each: (each.lineno, each.col_offset))
        method = syntax.function(first)
        if method is not None and not any(syntax.catches(each, CAUGHT) for each in places):
            yield EarlyRead(file, first, method.name, set_at[0], is_idle(syntax, first) or is_late(syntax, first))


def _is_store(node: ast.AST) -> TypeGuard[ast.Attribute]:
    return isinstance(node, ast.Attribute) and not isinstance(node.ctx, ast.Load)


def _by_name(places: Iterator[ast.Attribute]) -> dict[str, list[ast.Attribute]]:
    found: dict[str, list[ast.Attribute]] = {}
    for place in places:
        found.setdefault(place.attr, []).append(place)
    return found


def _may_come_after(syntax: Syntax, stores: list[ast.Attribute], uses: list[ast.Attribute]) -> bool:
    """Whether each assignment has a use above it in its function, be it in a branch."""
    lines: dict[ast.AST | None, int] = {}
    for each in uses:
        function = syntax.function(each)
        lines[function] = min(each.lineno, lines.get(function, each.lineno))
    return all(lines.get(syntax.function(each), each.lineno + 1) <= each.lineno for each in stores)


def _comes_after(syntax: Syntax, store: ast.Attribute, uses: set[ast.Attribute]) -> bool:
    """Whether an assignment runs only when one of some uses has run in the same call: in what is assigned, in a
    condition around it, or in a statement before it."""
    inner: ast.AST = store
    for outer, name in syntax.within(store):
        if isinstance(outer, ast.Assign) and _has(outer.value, uses):
            return True
        if name in ("body", "orelse") and isinstance(outer, ast.stmt) and _has(_first_of(outer), uses):
            return True
        if isinstance(inner, ast.stmt) and any(_has(_first_of(each), uses) for each in _before(outer, name, inner)):
            return True
        inner = outer
    function = syntax.function(store)
    return isinstance(inner, ast.stmt) and any(_has(_first_of(each), uses) for each in _before(function, "body", inner))


def _before(outer: ast.AST | None, name: str, statement: ast.stmt) -> list[ast.stmt]:
    """The statements of a block before one of them."""
    block = getattr(outer, name, None)
    return block[: block.index(statement)] if isinstance(block, list) and statement in block else []


def _first_of(statement: ast.stmt) -> ast.AST | None:
    """What of a statement runs in any case."""
    if isinstance(statement, (ast.If, ast.While)):
        return statement.test
    if isinstance(statement, (ast.For, ast.AsyncFor)):
        return statement.iter
    return None if hasattr(statement, "body") else statement


def _has(node: ast.AST | None, uses: set[ast.Attribute]) -> bool:
    """Whether a part that always runs is one of the uses."""
    todo = [node] if node is not None else []
    while todo:
        each = todo.pop()
        if each in uses:
            return True
        if isinstance(each, ast.BoolOp):
            todo.append(each.values[0])
        elif isinstance(each, ast.IfExp):
            todo.append(each.test)
        elif not isinstance(each, (*FUNCTIONS, *COMPREHENSIONS)):
            todo.extend(children(each))
    return False
