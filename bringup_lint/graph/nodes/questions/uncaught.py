"""What a callback runs outside every ``try`` that takes an exception, up to the executor."""

from __future__ import annotations

import ast
from collections.abc import Callable
from collections.abc import Iterator
from typing import TypeVar

from bringup_lint.graph.nodes.sources.sending import called
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import NodeClass

Found = TypeVar("Found")
_DEPTH = 4
_ALL = frozenset({"Exception", "BaseException"})


def uncaught(
    syntax: Syntax,
    cls: NodeClass,
    body: list[ast.AST],
    names: frozenset[str],
    look: Callable[[ast.AST], Found | None],
) -> Iterator[Found]:
    """What a look finds in the nodes that statements run, by themselves or through functions of the file, where nothing
    takes an exception of one of the names; each function once."""
    seen: set[ast.AST] = set()
    todo = [(body, 0)]
    while todo:
        statements, depth = todo.pop()
        for node in own(statements):
            found = look(node)
            if found is not None and not is_caught(syntax, node, names):
                yield found
            if isinstance(node, ast.Call) and depth < _DEPTH and not is_caught(syntax, node, names):
                for function, owner in called(syntax, node, cls):
                    if function not in seen and (owner is None or owner.source is cls.source):
                        seen.add(function)
                        todo.append((body_of(function), depth + 1))


def is_caught(syntax: Syntax, node: ast.AST, names: frozenset[str]) -> bool:
    """Whether a ``try`` or ``contextlib.suppress`` around a node, in its function, takes one of some exceptions."""
    if syntax.catches(node, names | _ALL):
        return True
    withs = (outer for outer, _ in syntax.within(node) if isinstance(outer, ast.With))
    return any("suppress" in ast.unparse(item.context_expr) for outer in withs for item in outer.items)
