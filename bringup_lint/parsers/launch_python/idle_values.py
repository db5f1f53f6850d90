"""Values that the code of a launch file keeps in variables which nothing that has an effect reads."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.python import children
from bringup_lint.parsers.launch_python.unbound import DYNAMIC
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.source import Span

_SCOPES = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)


@dataclass(eq=False, slots=True)
class _Seen:
    values: list[tuple[str, ast.expr]] = field(default_factory=list)
    """What functions assign to one variable."""
    read: set[str] = field(default_factory=set)
    """What is read elsewhere than in such a value."""
    inside: dict[str, set[str]] = field(default_factory=dict)
    """Variable -> what its values read."""


def idle_values(tree: ast.Module, positions: Positions) -> Iterator[Span]:
    """The values of the variables of functions that nothing reads but the values of other such variables."""
    seen = _Seen()
    todo: list[tuple[ast.AST, bool, str]] = [(tree, False, "")]
    while todo:
        node, is_local, owner = todo.pop()
        _note(seen, node, owner)
        name = _variable(node) if is_local and not owner else ""
        is_inner = isinstance(node, _SCOPES) or (is_local and not isinstance(node, ast.ClassDef))
        if isinstance(node, ast.Assign) and name:
            seen.values.append((name, node.value))
            todo.append((node.value, is_inner, name))
        else:
            todo.extend((child, is_inner, owner) for child in children(node))
    used = _used(seen)
    if used.isdisjoint(DYNAMIC):
        for name, value in seen.values:
            if name not in used:
                yield positions.span(value)


def _note(seen: _Seen, node: ast.AST, owner: str) -> None:
    if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Store):
        (seen.inside.setdefault(owner, set()) if owner else seen.read).add(node.id)
    elif isinstance(node, (ast.Global, ast.Nonlocal)):
        seen.read.update(node.names)


def _variable(node: ast.AST) -> str:
    """The variable that a statement gives a value."""
    if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
        return node.targets[0].id
    return ""


def _used(seen: _Seen) -> set[str]:
    """The names that are read, and what the values of those read."""
    used: set[str] = set()
    todo = list(seen.read)
    while todo:
        name = todo.pop()
        if name not in used:
            used.add(name)
            todo += seen.inside.get(name, ())
    return used
