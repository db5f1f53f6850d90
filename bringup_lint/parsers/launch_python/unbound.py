"""Names that the code of a launch file looks up and that nothing in the file binds."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.model.launch import UnboundName
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import walk
from bringup_lint.model.python import bound_names
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.source import Located

_OF_MODULES = frozenset({"__file__", "__name__", "__doc__", "__spec__", "__loader__", "__package__", "__builtins__"})
DYNAMIC = frozenset({"exec", "eval", "globals", "locals", "vars", "setattr", "__import__"})
"""Functions that may bind any name."""
_CATCHING = frozenset({"NameError", "Exception", "BaseException"})


def note_unbound(state: State, node: ast.Name) -> None:
    """Keep the first place where the code looks a name up that no frame has."""
    if node.id not in state.lacking:
        state.lacking[node.id] = (node, state.guards)


def unbound(state: State, tree: ast.Module) -> Iterator[UnboundName]:
    """Those of the names that were not found which no statement of the file can bind."""
    lacking = {name: found for name, found in state.lacking.items() if not hasattr(builtins, name)}
    if not lacking:
        return
    nodes = list(ast.walk(tree))
    bound = {name for node in nodes for name in bound_names(node)}
    if "*" in bound or any(isinstance(node, ast.Name) and node.id in DYNAMIC for node in nodes):
        return
    caught = caught_in(nodes, _CATCHING)
    chosen = _chosen(nodes)
    for name, (node, guards) in lacking.items():
        if name not in bound | _OF_MODULES and id(node) not in caught:
            place = Located(name, state.positions.span(node))
            yield UnboundName(place, bool(guards) or id(node) in chosen, tuple(dict.fromkeys(_arguments(guards))))


def _arguments(guards: Iterable[Condition]) -> Iterator[str]:
    return (each.name for guard in guards for each in walk(guard.predicate) if isinstance(each, Argument))


def _chosen(nodes: list[ast.AST]) -> set[int]:
    """What a value before it may leave out, in ``x if y else z``, ``x and y`` and ``x or y``; outer nodes first."""
    found: set[int] = set()
    for node in nodes:
        if id(node) in found:
            found.update(map(id, ast.iter_child_nodes(node)))
        elif isinstance(node, ast.IfExp):
            found |= {id(node.body), id(node.orelse)}
        elif isinstance(node, ast.BoolOp):
            found.update(map(id, node.values[1:]))
    return found


def caught_in(nodes: list[ast.AST], names: frozenset[str]) -> set[int]:
    """The nodes (by ``id``) whose exceptions of these names are caught."""
    return {id(inner) for node in nodes if _catches(node, names) for inner in _body(node)}


def _catches(node: ast.AST, names: frozenset[str]) -> bool:
    """``try``, and ``with suppress(NameError)``."""
    types: list[ast.expr | None] = [handler.type for handler in node.handlers] if isinstance(node, ast.Try) else []
    types += [item.context_expr for item in node.items] if isinstance(node, ast.With) else []
    words = (each for kind in types if kind is not None for each in ast.walk(kind) if isinstance(each, ast.Name))
    return None in types or any(word.id in names for word in words)


def _body(node: ast.AST) -> Iterator[ast.AST]:
    return (inner for statement in getattr(node, "body", ()) for inner in ast.walk(statement))
