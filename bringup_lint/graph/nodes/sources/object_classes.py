"""Of which class of the tree an object surely is, where the class builds on nothing and nothing builds on it."""

from __future__ import annotations

import ast
from collections import Counter
from collections import defaultdict
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.plain_classes import PlainClasses
from bringup_lint.graph.nodes.sources.plain_classes import plain_classes
from bringup_lint.graph.nodes.sources.tree_imports import Defined
from bringup_lint.graph.nodes.sources.tree_imports import Definition
from bringup_lint.graph.nodes.sources.tree_imports import definitions
from bringup_lint.graph.nodes.sources.tree_imports import own_definitions
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import bound_names
from bringup_lint.model.python import is_own
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_DYNAMIC = regex(
    r"__(?:getattr|dict__|slots__|setattr__|new__)|\bsetattr\b|\bvars\(|\bexec\(|\bpatch\.object",
    hints="__getattr __dict__ __slots__ __setattr__ __new__ setattr vars( exec( patch.object",
)
_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


@memo
def object_classes(nodes: Nodes, file: NodeSource) -> ObjectClasses:
    return ObjectClasses(nodes, file)


class ObjectClasses:
    """The objects that one file makes and keeps under one name, or in one attribute of ``self``."""

    def __init__(self, nodes: Nodes, file: NodeSource) -> None:
        self._file = file
        self._known = plain_classes(nodes)
        self._own = own_definitions(nodes, file)
        self._taken = definitions(nodes, file)

    def of(self, value: ast.expr) -> Defined | None:
        """The class of what an expression gives; None when that is not known."""
        if not self.any:
            return None
        if isinstance(value, ast.Name):
            return self._made.get(value.id)
        return self._kept.get(value.attr) if is_own(value) else None

    @property
    def any(self) -> bool:
        """Whether the file makes objects of such classes."""
        return bool(self._assigned)

    def lacks(self, found: Defined, name: str) -> bool:
        """Whether the objects of a class have no attribute of a name."""
        if name in self._known.foreign or hasattr(object, name):
            return False
        return name not in _of_class(self._known, found.node).named

    def method(self, found: Defined, name: str) -> FunctionNode | None:
        """The method that a name surely means, without decorators."""
        of_class = _of_class(self._known, found.node)
        return of_class.methods.get(name) if name not in self._known.foreign and name not in of_class.stored else None

    @cached_property
    def _made(self) -> dict[str, Defined]:
        """Name -> the class of the object that alone is given it in the file."""
        found: dict[str, list[Defined | None]] = defaultdict(list)
        for each in self._file.nodes:
            for name in bound_names(each):
                found[name].append(None)
        for target, made in self._assigned.items():
            if isinstance(target, ast.Name):
                found[target.id][0] = made
        return {name: made[0] for name, made in found.items() if len(made) == 1 and made[0] is not None}

    @cached_property
    def _kept(self) -> dict[str, Defined]:
        """Attribute -> the class of the object that alone is kept in it, but for None."""
        found: dict[str, set[Defined | None]] = defaultdict(set)
        for each in self._file.nodes:
            if isinstance(each, ast.Attribute) and not isinstance(each.ctx, ast.Load) and each not in self._empty:
                found[each.attr].add(self._assigned.get(each) if is_own(each) else None)
        foreign = self._known.foreign
        alone = {name: next(iter(made)) for name, made in found.items() if len(made) == 1 and name not in foreign}
        return {name: made for name, made in alone.items() if made is not None}

    @cached_property
    def _assignments(self) -> dict[ast.expr, ast.expr]:
        """Target -> value of the assignments to one target."""
        found = {}
        for each in self._file.nodes:
            if isinstance(each, ast.Assign) and len(each.targets) == 1:
                found[each.targets[0]] = each.value
            elif isinstance(each, ast.AnnAssign) and each.value is not None:
                found[each.target] = each.value
        return found

    @cached_property
    def _assigned(self) -> dict[ast.expr, Defined]:
        """Target -> the class whose object it gets."""
        made = {target: self._class_of(value) for target, value in self._assignments.items()}
        return {target: found for target, found in made.items() if found is not None}

    @cached_property
    def _empty(self) -> set[ast.expr]:
        """The targets that get None."""
        values = self._assignments.items()
        return {target for target, value in values if isinstance(value, ast.Constant) and value.value is None}

    def _class_of(self, value: ast.expr) -> Defined | None:
        name = value.func.id if isinstance(value, ast.Call) and isinstance(value.func, ast.Name) else ""
        own = self._own.get(name)
        found = self._taken.get(name) if own is None else Defined(self._file, own)
        if found is None or not isinstance(found.node, ast.ClassDef) or not self._known.knows(found.node):
            return None
        return None if found.file.source.matches(_DYNAMIC) else found


class _OfClass(NamedTuple):
    """The names in one class, be they in a method."""

    named: frozenset[str]
    """What gets a value or a definition."""
    stored: frozenset[str]
    """The attributes of them."""
    methods: dict[str, FunctionNode]
    """Those that a name surely means, without decorators."""


@memo
def _of_class(known: PlainClasses, node: Definition) -> _OfClass:
    every = list(walk(node))
    stored = frozenset(name for each in every for name in _stored(each))
    defined = Counter(each.name for each in every if isinstance(each, _FUNCTIONS))
    plain = (each for each in node.body if isinstance(each, _FUNCTIONS) and not each.decorator_list)
    methods = {each.name: each for each in plain if defined[each.name] == 1}
    return _OfClass(stored.union(*map(bound_names, every)), stored, methods)


def _stored(node: ast.AST) -> tuple[str, ...]:
    if isinstance(node, ast.Attribute) and not isinstance(node.ctx, ast.Load):
        return (node.attr,)
    return ()
