"""Python sources of nodes, read from the syntax tree; nothing of them is ever executed or imported."""

from __future__ import annotations

import ast
from collections.abc import Callable
from collections.abc import Iterable
from functools import partial
from typing import Any

from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.parsers.python_node.classes import ROOTS
from bringup_lint.parsers.python_node.classes import declare
from bringup_lint.parsers.python_node.classes import function
from bringup_lint.parsers.python_node.classes import given_name
from bringup_lint.parsers.python_node.classes import judge
from bringup_lint.parsers.python_node.classes import node_class
from bringup_lint.parsers.python_node.endpoints import made_by
from bringup_lint.parsers.python_node.scopes import Call
from bringup_lint.parsers.python_node.scopes import ClassScope
from bringup_lint.parsers.python_node.scopes import Module
from bringup_lint.parsers.python_node.scopes import Scope
from bringup_lint.parsers.python_node.scopes import read_module
from bringup_lint.parsers.python_node.values import UNKNOWN
from bringup_lint.parsers.python_node.values import Called
from bringup_lint.parsers.python_node.values import Read
from bringup_lint.parsers.python_node.values import Symbol
from bringup_lint.parsers.python_node.values import Values
from bringup_lint.parsers.python_node.values import argument
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import byte_order_mark
from bringup_lint.parsers.python_syntax import kept_tree
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

TEXT = 2_000_000
"""Code points of a node source."""
INSTANCES = 50
"""Calls that make a node of one class; with more, its name is not known."""
_DECLARE = ("declare_parameter", "declare_parameters")


def parse(source: Source) -> NodeSource:
    """The classes, endpoints and parameters of a file. Never raises; ``problems``: ``syntax``, ``too-large``."""
    file = NodeSource(source, span_of=lambda node: source.whole, qualified=lambda node: None)
    file.constant = file.named = lambda *_: None
    if len(source.text) > TEXT:
        file.problems.append(Problem("too-large", source.whole))
        return file
    tree, problems = kept_tree(source)
    file.problems += problems
    if tree is None:
        return file
    try:
        _read(file, tree)
    except RecursionError:
        file.problems.append(Problem("too-deep", source.whole))
    return file


def let_go(sources: Iterable[Source]) -> None:
    """Forget what was read of sources for this run alone."""
    for source in sources:
        file = source.forget(parse)
        source.forget(kept_tree)
        if isinstance(file, NodeSource):
            file.let_go()


def _read(file: NodeSource, tree: ast.Module) -> None:
    positions = Positions(file.source, byte_order_mark(file.source))
    module = read_module(tree)
    values = Values(module, positions, {})
    file.tree, file.nodes, file.span_of = tree, list(walk(tree)), positions.span
    file.imports, file.stars = module.imports, module.stars
    file.functions = {name: function(values, node) for name, node in module.functions.items()}
    file.main = module.main if module.main is not None else "main" if "main" in module.functions else None
    if not module.complete:
        file.problems.append(Problem("too-large", file.source.whole))
    file.joined, file.exported = partial(_joined, file, module, positions), partial(_exported, module, positions)
    _run(file, module, values)


def _run(file: NodeSource, module: Module, values: Values) -> None:
    reading = Reading(file, module, values)
    file.qualified = values.qualified
    file.constant, file.named, file.let_go = reading.constant, reading.named, reading.let_go
    reading.run()


def _joined(file: NodeSource, module: Module, positions: Positions, imported: Callable[[str], Any]) -> NodeSource:
    again = NodeSource(file.source, main=file.main, tree=file.tree, nodes=file.nodes, span_of=file.span_of)
    again.functions, again.imports, again.stars = file.functions, file.imports, file.stars
    again.problems, again.is_alone = file.problems, False
    _run(again, module, Values(module, positions, {}, imported))
    return again


def _exported(module: Module, positions: Positions, path: list[str], imported: Callable[[str], Any]) -> Any:
    return Values(module, positions, {}, imported).exported(path)


class Reading:
    """One file: its classes first, then what each call adds to them."""

    def __init__(self, file: NodeSource, module: Module, values: Values) -> None:
        self.file = file
        self.module = module
        self.values = values
        self.classes: dict[int, NodeClass] = {}
        self.single: dict[int, NodeClass] = {}
        """Nodes that a call makes, by the ``id`` of the call."""
        self.class_scopes: dict[int, ClassScope] = {}
        """Class of the model (by ``id``) -> its scope."""
        self.instances: dict[str, list[Call]] = {}
        """Class of the file -> the calls that make one."""

    def run(self) -> None:
        for scope in self.module.all_classes:
            found = self.classes[id(scope)] = node_class(self.values, scope)
            self.class_scopes[id(found)] = scope
        for scope in self.module.all_classes:
            if scope.base is not None:
                self.classes[id(scope)].base = self.classes[id(scope.base)]
        for found in self.classes.values():
            judge(found)
        self.file.classes += [found for found in self.classes.values() if found.is_node is not False]
        for call in self.module.calls:
            self.declare(call)
        for call in self.module.calls:
            name = self.values.qualified(call.node.func, call.scope)
            if name in ROOTS:
                self.make(call)
            elif name in self.module.classes:
                self.instances.setdefault(name, []).append(call)
        for call in self.module.calls:
            self.add(call)
        for scope in self.module.all_classes:
            self.name(scope)

    def let_go(self) -> None:
        file, unread = self.file, NodeSource(self.file.source)
        file.tree, file.nodes = None, []
        file.constant, file.named, file.let_go = unread.constant, unread.named, unread.let_go
        file.joined, file.exported = unread.joined, unread.exported
        if file.is_alone:  # else the scopes belong to the file that was read without the others
            for scope in self.module.scopes.values():
                scope.cls = scope.parent = None

    def constant(self, node: ast.expr, within: ast.AST | None = None) -> Any:
        """The literal value of an expression that is in a function; None when it is not known."""
        value = self.values.of(node, self.module.scopes.get(id(within), self.module.scope))
        return None if value is UNKNOWN or isinstance(value, (Symbol, Called, Read)) else value

    def named(self, node: ast.expr, within: ast.AST | None = None) -> str | None:
        """The dotted name of something imported, of a class of the file, or of what was called to make the value."""
        value = self.values.of(node, self.module.scopes.get(id(within), self.module.scope))
        return value.name if isinstance(value, (Symbol, Called)) else None

    def declare(self, call: Call) -> None:
        function = call.node.func
        if not isinstance(function, ast.Attribute) or function.attr not in _DECLARE:
            return
        owner = self.owner(function.value, call.scope)
        if owner is None:
            return
        for parameter in declare(self.values, call, function.attr):
            known = owner.parameters.setdefault(str(parameter.name), parameter)
            scope = self.class_scopes.get(id(owner))
            if scope is not None:
                same = known is parameter or known.default == parameter.default
                default = parameter.default if parameter.known and same else UNKNOWN
                self.values.parameters.setdefault(id(scope), {})[str(parameter.name)] = default

    def make(self, call: Call) -> None:
        """A node without a class of its own."""
        kept = call.kept
        node = NodeClass(self.file.source, None, self.values.span(call.node), is_node=True)
        base = self.values.qualified(call.node.func, call.scope) or ""
        node.bases = (base,)
        node.is_lifecycle = "lifecycle" in base
        if isinstance(kept, (ast.Name, ast.Attribute)):
            node.variable = written(kept)
        node.node_name = self.text(argument(call.node, 0, "node_name"), call.scope)
        node.namespace = self.text(argument(call.node, 99, "namespace"), call.scope)
        self.single[id(call.node)] = node
        self.file.classes.append(node)

    def text(self, node: ast.expr | None, scope: Scope) -> Located | None:
        value = self.values.of(node, scope) if node is not None else None
        return value if isinstance(value, Located) else None

    def add(self, call: Call) -> None:
        made = made_by(self.values, call)
        if made is None:
            return
        owner = self.owner(made.owner, call.scope)
        if made.owner is None and call.scope.cls is not None:
            owner = self.classes[id(call.scope.cls)]
        if owner is None:
            self.file.strays += made.endpoints
            return
        owner.endpoints += made.endpoints
        owner.timers += made.timers
        owner.callbacks += made.callbacks

    def owner(self, node: ast.expr | None, scope: Scope) -> NodeClass | None:
        """The node that an expression stands for."""
        if node is None:
            return None
        cls: ClassScope | None = scope.cls
        if cls is not None and _is_self(node, scope):
            own = self.classes[id(cls)]
            return own if own.is_node is not False else None
        value = self.values.of(node, scope)
        if not isinstance(value, Called):
            return None
        if id(value.call) in self.single:
            return self.single[id(value.call)]
        local = self.module.classes.get(value.name)
        return self.classes[id(local)] if local is not None else None

    def name(self, scope: ClassScope) -> None:
        found = self.classes[id(scope)]
        if found.is_node is not True:
            return
        calls = self.instances.get(scope.node.name, [])
        if len(calls) > INSTANCES:
            return
        for keyword in ("node_name", "namespace"):
            given = [given_name(self.values, scope, call.node, call.scope, keyword) for call in calls]
            given = given or [given_name(self.values, scope, None, self.module.scope, keyword)]
            if isinstance(given[0], Located) and all(isinstance(each, Located) and each == given[0] for each in given):
                setattr(found, keyword, given[0])


def _is_self(node: ast.expr, scope: Scope) -> bool:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "super":
        return True
    return isinstance(node, ast.Name) and node.id == scope.self_name
