"""A loop has no condition in what it goes over."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from tests.architecture.imports import nodes
from tests.architecture.imports import paths
from tests.conftest import PROJECT


def is_empty(node: ast.expr) -> bool:
    return isinstance(node, (ast.Tuple, ast.List)) and not node.elts


def loops_with_a_condition(path: Path) -> Iterator[str]:
    """Every ``for x in xs if condition else ()``."""
    for node in nodes(path):
        over = node.iter if isinstance(node, (ast.For, ast.AsyncFor, ast.comprehension)) else None
        if isinstance(over, ast.IfExp) and (is_empty(over.orelse) or is_empty(over.body)):
            yield f"{path.relative_to(PROJECT)}:{over.lineno}"


def test_no_loop_goes_over_nothing_by_a_condition() -> None:
    """A guard clause, or an ``if`` around the loop, says it plainly."""
    places = [*paths(), *sorted((PROJECT / "rules").rglob("*.py"))]
    assert [found for path in places for found in loops_with_a_condition(path)] == []
