"""Attributes and methods of objects whose class is in the tree and has none of the name."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.python.missing_attributes import CAUGHT
from bringup_lint.graph.nodes.questions.python.missing_attributes import asked_for
from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.idle import is_late
from bringup_lint.graph.nodes.sources.object_classes import object_classes
from bringup_lint.graph.nodes.sources.tree_imports import Defined
from bringup_lint.model.node_source import NodeSource
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.nodes.sources.syntax import Syntax

EXPECTED = frozenset({"AttributeError"})


class ObjectAttribute(NamedTuple):
    file: NodeSource
    place: ast.Attribute
    defined: Defined
    """The class."""
    function: str | None
    """Where it is used; None: when the file is loaded."""
    idle: bool
    caught: bool


def object_attributes(nodes: Nodes) -> Iterator[ObjectAttribute]:
    """The first use of each attribute of the objects of one class in a file."""
    for file in nodes.robot_code:
        objects, syntax = object_classes(nodes, file), nodes.syntax(file)
        if not objects.any:
            continue
        seen: set[tuple[ast.AST, str]] = set()
        for place in file.nodes:
            if not isinstance(place, ast.Attribute) or not isinstance(place.ctx, ast.Load):
                continue
            defined = objects.of(place.value)
            if defined is None or (defined.node, place.attr) in seen or not objects.lacks(defined, place.attr):
                continue
            if place.attr in asked_for(file) or syntax.is_dead(place) or syntax.catches(place, EXPECTED):
                continue
            seen.add((defined.node, place.attr))
            yield lacking(file, syntax, place, defined)


def lacking(file: NodeSource, syntax: Syntax, place: ast.Attribute, defined: Defined) -> ObjectAttribute:
    """What a class lacks that a place takes from it."""
    function = syntax.function(place)
    idle = is_idle(syntax, place) or is_late(syntax, place)
    named = function.name if function is not None else None
    return ObjectAttribute(file, place, defined, named, idle, syntax.catches(place, CAUGHT))
