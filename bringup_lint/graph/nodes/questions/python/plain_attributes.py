"""Attributes that the classes beside the nodes of a program use and nothing sets."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.python.missing_attributes import CAUGHT
from bringup_lint.graph.nodes.questions.python.missing_attributes import DYNAMIC
from bringup_lint.graph.nodes.questions.python.missing_attributes import asked_for
from bringup_lint.graph.nodes.questions.python.missing_attributes import set_in_body
from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.idle import is_late
from bringup_lint.graph.nodes.sources.plain_classes import plain_classes
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import is_own
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_EXPECTED = frozenset({"AttributeError"})
_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


class PlainAttribute(NamedTuple):
    file: NodeSource
    place: ast.Attribute
    owner: str
    function: str
    idle: bool
    caught: bool


def plain_attributes(nodes: Nodes) -> Iterator[list[PlainAttribute]]:
    """The uses of each attribute together, in classes that build on nothing, that nothing builds on, and that the code
    makes."""
    tree = plain_classes(nodes)
    for file in nodes.robot_code:
        if file.stars or file.source.matches(DYNAMIC):
            continue
        owners = [each for each in file.nodes if isinstance(each, ast.ClassDef) and tree.knows(each)]
        asked = asked_for(file) if owners else set()
        for owner in owners:
            yield from _of_class(nodes, file, owner, (tree.foreign, asked))


def _of_class(
    nodes: Nodes, file: NodeSource, owner: ast.ClassDef, foreign: tuple[set[str], set[str]]
) -> Iterator[list[PlainAttribute]]:
    syntax = nodes.syntax(file)
    known = {*dir(object), *set_in_body(owner)}
    inner = [each for each in walk(owner) if isinstance(each, ast.Attribute)]
    known.update(each.attr for each in inner if not isinstance(each.ctx, ast.Load))
    groups: dict[str, list[PlainAttribute]] = {}
    for method in owner.body:
        if isinstance(method, _FUNCTIONS) and _has_self(method):
            for place in walk(method):
                if is_own(place) and not place.attr.startswith("__"):
                    if any(place.attr in each for each in (known, *foreign)):
                        continue
                    if syntax.definition(place) is owner and not _is_harmless(syntax, place):
                        groups.setdefault(place.attr, []).append(_found(file, syntax, owner, method, place))
    yield from groups.values()


def _is_harmless(syntax: Syntax, place: ast.Attribute) -> bool:
    """Whether a use never runs, or its exception is expected."""
    return syntax.is_dead(place) or syntax.catches(place, _EXPECTED)


def _found(
    file: NodeSource, syntax: Syntax, owner: ast.ClassDef, method: FunctionNode, place: ast.Attribute
) -> PlainAttribute:
    idle = is_idle(syntax, place) or is_late(syntax, place)
    return PlainAttribute(file, place, owner.name, method.name, idle, syntax.catches(place, CAUGHT))


def _has_self(method: FunctionNode) -> bool:
    arguments = [*method.args.posonlyargs, *method.args.args]
    return not method.decorator_list and bool(arguments) and arguments[0].arg == "self"
