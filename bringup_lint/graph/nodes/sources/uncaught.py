"""What a callback runs outside every ``try`` that takes an exception, up to the executor."""

from __future__ import annotations

import ast
from collections.abc import Callable
from collections.abc import Iterator
from typing import Generic
from typing import TypeVar

from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.sending import called
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.python import written

Found = TypeVar("Found")
_DEPTH = 4
_ALL = frozenset({"Exception", "BaseException"})


class Uncaught(Generic[Found]):
    """What a look finds in the code that callbacks of a class run, by itself or through functions of the file, where
    nothing takes an exception of one of the names. Each function is looked at once for all callbacks."""

    def __init__(
        self, syntax: Syntax, cls: NodeClass, names: frozenset[str], look: Callable[[ast.AST], Found | None]
    ) -> None:
        self._syntax = syntax
        self._cls = cls
        self._names = names
        self._look = look

    def of(self, body: list[ast.AST]) -> Iterator[Found]:
        """What is found in the statements of a callback, each function once."""
        seen: set[ast.AST] = set()
        todo = [(self._in(body), 0)]
        while todo:
            (found, functions), depth = todo.pop()
            yield from found
            new = [function for function in functions if function not in seen and depth < _DEPTH]
            seen.update(new)
            todo.extend((self._in_function(function), depth + 1) for function in new)

    @memo
    def _in_function(self, function: ast.AST) -> tuple[list[Found], list[ast.AST]]:
        return self._in(body_of(function))

    def _in(self, statements: list[ast.AST]) -> tuple[list[Found], list[ast.AST]]:
        """What is found in statements themselves, and the functions that they call."""
        found: list[Found] = []
        functions: dict[ast.AST, None] = {}
        for node in own(statements):
            one = self._look(node)
            if one is not None and not is_caught(self._syntax, node, self._names):
                found.append(one)
            if isinstance(node, ast.Call) and not is_caught(self._syntax, node, self._names):
                for function, owner in called(self._syntax, node, self._cls):
                    if owner is None or owner.source is self._cls.source:
                        functions[function] = None
        return found, list(functions)


def is_caught(syntax: Syntax, node: ast.AST, names: frozenset[str]) -> bool:
    """Whether a ``try`` or ``contextlib.suppress`` around a node, in its function, takes one of some exceptions."""
    if syntax.catches(node, names | _ALL):
        return True
    withs = (outer for outer, _ in syntax.within(node) if isinstance(outer, ast.With))
    return any("suppress" in written(item.context_expr) for outer in withs for item in outer.items)
