"""Objects that a node keeps to talk to its hardware, and the classes of the workspace that they are of."""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.stored_values import module_values
from bringup_lint.graph.nodes.sources.stored_values import stored
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import calls_through
from bringup_lint.graph.nodes.sources.syntax import methods_of
from bringup_lint.graph.nodes.sources.uncaught import is_caught
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import is_own
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_DEPTH = 3


class Driver(NamedTuple):
    """A class of the workspace."""

    file: NodeSource
    methods: dict[str, ast.FunctionDef]


def made_of(syntax: Syntax, cls: NodeClass, value: ast.expr) -> ast.Call | None:
    """The call that makes what an attribute or a variable of the module always holds."""
    if is_own(value):
        values = stored(syntax, cls, value)
    elif isinstance(value, ast.Name):
        values = module_values(syntax).get(value.id, [])
    else:
        return None
    first = values[0] if len(values) == 1 else None
    return first if isinstance(first, ast.Call) else None


def driver_of(nodes: Nodes, file: NodeSource, made: ast.Call) -> Driver | None:
    """The class of the workspace whose object a call makes."""
    dotted = nodes.syntax(file).qualified(made) or ""
    module, _, name = dotted.rpartition(".")
    others = [nodes.module_named(module, file)] if module else [file]
    if isinstance(made.func, ast.Name) and (not module or others[0] is None):
        others = [file, *(nodes.module_named(each, file) for each in file.stars)]
        name = made.func.id
    for other in others:
        methods = methods_of(other.tree.body, name) if other is not None and other.tree is not None else None
        if other is not None and methods is not None:
            return Driver(other, methods)
    return None


def first_uncaught(
    nodes: Nodes, driver: Driver, method: str, names: frozenset[str], look: Callable[[ast.Call], bool]
) -> ast.Call | None:
    """The first call of a kind that a method makes, itself or through others of its class, and where nothing in the
    class takes an exception of one of the names."""
    syntax = nodes.syntax(driver.file)
    calls = calls_through(driver.methods, method, _DEPTH, lambda call: is_caught(syntax, call, names))
    return next((call for call in calls if look(call)), None)
