"""No pattern is compiled while modules load: ``regex`` compiles it when it is first asked."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from bringup_lint.pattern import regex
from tests.architecture.imports import paths
from tests.architecture.imports import syntax
from tests.conftest import PROJECT


def compiled_on_import(node: ast.AST) -> Iterator[ast.AST]:
    """The uses of ``re.compile`` that run when their module is imported."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, (ast.FunctionDef, ast.Lambda)):
            continue
        if isinstance(child, ast.Attribute) and child.attr == "compile" and ast.unparse(child) == "re.compile":
            yield child
        yield from compiled_on_import(child)


def places(path: Path) -> Iterator[str]:
    for node in compiled_on_import(syntax(path)):
        yield f"{path.relative_to(PROJECT)}:{getattr(node, 'lineno', 0)}"


def test_no_module_compiles_patterns_when_it_is_imported() -> None:
    files = [*paths(), *sorted((PROJECT / "rules").rglob("*.py"))]
    assert [place for path in files for place in places(path)] == []


def test_a_pattern_answers_as_the_compiled_one_does() -> None:
    pattern = regex("(?P<word>[a-z]+)")
    match = pattern.fullmatch("rover")
    assert match is not None and match["word"] == "rover"
    assert pattern.pattern == "(?P<word>[a-z]+)"
    assert pattern.groupindex == {"word": 1}
    assert pattern.sub("-", "a1b") == "-1-"
    assert regex(b"a", 0).search(b"ba") is not None
