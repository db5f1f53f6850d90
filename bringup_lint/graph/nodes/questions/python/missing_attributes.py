"""Attributes of nodes that nothing sets, and those that rclpy keeps for itself."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import Union

from bringup_lint.facts import table
from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.idle import is_late
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_node.classes import ROOTS
from bringup_lint.pattern import regex
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

DYNAMIC = regex(
    r"__(?:getattr|dict__|slots__|setattr__)|setattr(?<=\bsetattr)\b|(?:vars|exec)\((?<=\b.{5})|patch(?<=\bpatch)\.object",
    hints="__getattr __dict__ __slots__ __setattr__ setattr vars( exec( patch.object",
)
_ASKS = regex(r"\b(?:hasattr|getattr|delattr|attrgetter)\b", hints="hasattr getattr delattr attrgetter")
_PLAIN_BASES = frozenset({"abc.ABC", "ABC", "object"})
CAUGHT = frozenset({"AttributeError", "Exception", "BaseException"})
_POOLS = ("concurrent.futures.ThreadPoolExecutor", "concurrent.futures.ProcessPoolExecutor")

Heirs = dict[Union[NodeClass, str], list[NodeClass]]


class MissingAttribute(NamedTuple):
    file: NodeSource
    place: ast.Attribute
    owner: NodeClass
    function: str
    """The method that uses it."""
    like: str | None
    """An attribute of nearly the same name, which the class has."""
    idle: bool
    """Nothing calls the method, or the node has done its work by then."""


class TakenAttribute(NamedTuple):
    """An assignment to a property of rclpy that has no setter, or takes only an executor of rclpy."""

    file: NodeSource
    place: ast.Attribute


def missing_attributes(nodes: Nodes) -> Iterator[list[MissingAttribute]]:
    """The first use of each attribute that no code of the tree sets, of classes whose bases are all known; those of one
    method together."""
    of_ros = {row["name"] for row in table("ros/node_attributes")} | set(dir(object))
    foreign = nodes.set_elsewhere
    heirs = heirs_of(nodes)
    for file, node in nodes.node_classes:
        family = family_of(nodes, node, heirs)
        if node.node is None or family is None:
            continue
        known = of_ros | foreign | {name for each in family for name in _names(each)}
        texts = asked_for(file)
        groups: dict[str, list[MissingAttribute]] = {}
        for found in _unknown(nodes, file, node, known, texts):
            groups.setdefault(found.function, []).append(found)
        yield from groups.values()


def _unknown(
    nodes: Nodes, file: NodeSource, node: NodeClass, known: set[str], texts: set[str]
) -> Iterator[MissingAttribute]:
    syntax = nodes.syntax(file)
    seen: set[str] = set()
    uses = (*own_uses(syntax, node), *own_additions(syntax, node))
    for place in sorted(uses, key=lambda each: (each.lineno, each.col_offset)):
        name = place.attr
        if name in known or name in texts or name in seen or name.startswith("__"):
            continue
        if syntax.catches(place, CAUGHT) or syntax.is_dead(place):
            continue
        seen.add(name)
        function = syntax.function(place)
        label = function.name if function is not None else ""
        near = nearest(name, known)
        like = near[0] if len(near) == 1 else None
        is_unlikely = is_idle(syntax, place) or is_late(syntax, place)
        yield MissingAttribute(file, place, node, label, like, is_unlikely)


def asked_for(file: NodeSource) -> set[str]:
    """The texts of a file that asks an object by a text whether it has an attribute."""
    if not file.source.matches(_ASKS):
        return set()
    return {str(each.value) for each in file.nodes if isinstance(each, ast.Constant) and isinstance(each.value, str)}


def taken_attributes(nodes: Nodes) -> Iterator[TakenAttribute]:
    read_only = {row["name"] for row in table("ros/node_attributes") if row["kind"] == "read-only"}
    for file, node in nodes.node_classes:
        if node.node is None:
            continue
        own = {name for each in node.lineage if each.node is not None for name in set_in_body(each.node)}
        for place, value in _assignments(nodes.syntax(file), node):
            pool = file.named(value, nodes.syntax(file).function(place)) if place.attr == "executor" else None
            if place.attr not in own and (place.attr in read_only or pool in _POOLS):
                yield TakenAttribute(file, place)


def family_of(nodes: Nodes, node: NodeClass, heirs: Heirs) -> list[NodeClass] | None:
    """A class, all that it builds on and all that builds on it; None when not all of that is known."""
    lineage = list(node.lineage)
    for each in lineage:
        plain = [base for base in each.bases if base not in _PLAIN_BASES]
        if each.node is None or each.node.decorator_list or each.node.keywords or len(plain) != 1:
            return None
        if each.base is None and plain[0] not in ROOTS:
            return None
    files = {nodes.file_of(each) for each in lineage}
    if any(file.stars or file.source.matches(DYNAMIC) for file in files):
        return None
    named = heirs.get(node.name, ()) if node.name is not None else ()
    return [*lineage, *heirs.get(node, ()), *named]


def heirs_of(nodes: Nodes) -> Heirs:
    """A class, or the name of one -> those that build on it."""
    found: Heirs = {}
    for file in nodes.sources:
        for each in file.classes:
            keys: list[NodeClass | str] = [*each.lineage, *(base.rpartition(".")[2] for base in each.bases)]
            for key in keys:
                found.setdefault(key, []).append(each)
    return found


def _names(node: NodeClass) -> Iterator[str]:
    """What a class defines, and what its methods set on anything."""
    if node.node is None:
        return
    yield from set_in_body(node.node)
    added_to = {each.target for each in node.inner if isinstance(each, ast.AugAssign)}
    for each in node.inner:
        if isinstance(each, ast.Attribute) and not isinstance(each.ctx, ast.Load) and each not in added_to:
            yield each.attr


def set_in_body(node: ast.ClassDef) -> Iterator[str]:
    """The names that a class body binds."""
    for statement in node.body:
        if isinstance(statement, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            yield statement.name
            continue
        for each in walk(statement):
            if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store):
                yield each.id
            elif isinstance(each, (ast.FunctionDef, ast.ClassDef)):
                yield each.name
            elif isinstance(each, ast.alias):
                yield each.asname or each.name


def own_uses(syntax: Syntax, node: NodeClass) -> Iterator[ast.Attribute]:
    """``self.x`` in the methods of a class."""
    for each in node.inner:
        if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Load) and _is_self(syntax, node, each):
            yield each


def own_additions(syntax: Syntax, node: NodeClass) -> Iterator[ast.Attribute]:
    """``self.x`` of ``self.x += 1`` in the methods of a class, which needs a value as much as a use does."""
    for each in node.inner:
        target = each.target if isinstance(each, ast.AugAssign) else None
        if isinstance(target, ast.Attribute) and _is_self(syntax, node, target):
            yield target


def _is_self(syntax: Syntax, node: NodeClass, place: ast.Attribute) -> bool:
    """Whether an attribute is one of ``self`` in a method of this class, and not of a class within it."""
    if not isinstance(place.value, ast.Name) or place.value.id != "self":
        return False
    method = None
    for outer, _ in syntax.above(place):
        if isinstance(outer, ast.ClassDef):
            return outer is node.node and method is not None and _first(method) == "self"
        if isinstance(outer, (ast.FunctionDef, ast.AsyncFunctionDef)):
            method = outer
    return False


def _first(method: FunctionNode) -> str | None:
    arguments = [*method.args.posonlyargs, *method.args.args]
    return arguments[0].arg if arguments else None


def _assignments(syntax: Syntax, node: NodeClass) -> Iterator[tuple[ast.Attribute, ast.expr]]:
    for each in node.inner:
        if isinstance(each, (ast.Assign, ast.AnnAssign)) and each.value is not None:
            for target in each.targets if isinstance(each, ast.Assign) else (each.target,):
                if isinstance(target, ast.Attribute) and _is_self(syntax, node, target):
                    yield target, each.value
