"""Syntax of Python may be deep: nothing recurses through it, but where ``model/python.py`` has looked how deep."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.architecture.imports import PACKAGE
from tests.architecture.imports import nodes
from tests.architecture.imports import paths
from tests.conftest import PROJECT

RECURSIVE = frozenset(("unparse", "dump", "NodeVisitor", "NodeTransformer"))
ALLOWED = PACKAGE / "model" / "python.py"


@pytest.mark.parametrize("folder", ["bringup_lint", "rules"])
def test_no_module_calls_what_recurses_through_syntax(folder: str) -> None:
    files = [path for path in (*paths(), *PROJECT.glob("rules/*/*.py")) if path != ALLOWED]
    found = [(path.name, name) for path in files if path.is_relative_to(PROJECT / folder) for name in recursive(path)]
    assert found == []


def test_the_one_place_does() -> None:
    assert recursive(ALLOWED) == ["unparse"]


def recursive(path: Path) -> list[str]:
    """The functions and classes of ``ast`` that recurse, and that a module names."""
    return [
        node.attr
        for node in nodes(path)
        if isinstance(node, ast.Attribute) and node.attr in RECURSIVE and isinstance(node.value, ast.Name)
        if node.value.id == "ast"
    ]
