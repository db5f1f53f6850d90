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
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_own
from bringup_lint.model.python import is_self
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_PLAIN_BASES = frozenset({"object", "ABC"})
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
    tree = _Tree(nodes)
    for file in nodes.robot_code:
        if file.stars or file.source.matches(DYNAMIC):
            continue
        owners = [each for each in file.nodes if isinstance(each, ast.ClassDef) and tree.knows(each)]
        asked = asked_for(file) if owners else set()
        for owner in owners:
            yield from _of_class(nodes, file, owner, (tree.foreign, asked))


class _Tree:
    """What all files of the tree say of classes and of the attributes of objects."""

    def __init__(self, nodes: Nodes) -> None:
        self.foreign: set[str] = set()
        """Attributes that code sets on something else than ``self``."""
        self._bases: set[str] = set()
        self._made: set[str] = set()
        for file in nodes.robot_code:
            for node in file.nodes:
                if isinstance(node, ast.Attribute) and not isinstance(node.ctx, ast.Load):
                    if not is_self(node.value):
                        self.foreign.add(node.attr)
                elif isinstance(node, ast.ClassDef):
                    self._bases.update(map(_last_name, node.bases))
                elif isinstance(node, ast.Call):
                    self._made.add(called_name(node))

    def knows(self, node: ast.ClassDef) -> bool:
        is_open = node.decorator_list or node.keywords or not all(map(_is_plain, node.bases))
        return not is_open and node.name in self._made and node.name not in self._bases


def _last_name(base: ast.expr) -> str:
    return base.attr if isinstance(base, ast.Attribute) else base.id if isinstance(base, ast.Name) else ""


def _is_plain(base: ast.expr) -> bool:
    is_of_abc = isinstance(base, ast.Attribute) and isinstance(base.value, ast.Name) and base.value.id == "abc"
    return (is_of_abc or isinstance(base, ast.Name)) and _last_name(base) in _PLAIN_BASES


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
