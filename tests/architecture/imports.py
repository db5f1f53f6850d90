"""Who imports whom in the package: every import counts, also inside functions and for type checkers only."""

from __future__ import annotations

import ast
from collections.abc import Collection
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from tests.conftest import PROJECT

PACKAGE = PROJECT / "bringup_lint"


def paths() -> list[Path]:
    return sorted(path for path in PACKAGE.rglob("*.py") if "rules" not in path.relative_to(PACKAGE).parts)


def name_of(path: Path) -> str:
    """Below the package: ``graph.systemd.unit``; a package goes by its folder, the top one by an empty name."""
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def syntax(path: Path) -> ast.Module:
    return ast.parse(path.read_text("utf-8"))


@cache
def nodes(path: Path) -> tuple[ast.AST, ...]:
    """All nodes of the syntax of a file, which several tests look at."""
    return tuple(ast.walk(syntax(path)))


@cache
def import_graph() -> dict[str, frozenset[str]]:
    """Module -> the modules of the package that it imports."""
    modules = {name_of(path): path for path in paths()}
    return {name: frozenset(_imports(path, modules.keys())) - {name} for name, path in modules.items()}


def _imports(path: Path, modules: Collection[str]) -> Iterator[str]:
    for node in nodes(path):
        if isinstance(node, ast.Import):
            names = [(alias.name, alias.name) for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            names = [(f"{node.module}.{alias.name}", node.module) for alias in node.names]
        else:
            continue
        for member, module in names:
            name = next((each for each in map(_below_package, (member, module)) if each in modules), None)
            if name is not None:
                yield name


def _below_package(module: str) -> str | None:
    package, _, name = module.partition(".")
    return name if package == PACKAGE.name else None


def circles(graph: dict[str, frozenset[str]]) -> list[frozenset[str]]:
    """The strongly connected components of more than one module (Tarjan)."""
    order: dict[str, int] = {}
    lowest: dict[str, int] = {}
    stack: list[str] = []
    found: list[frozenset[str]] = []

    def visit(name: str) -> None:
        order[name] = lowest[name] = len(order)
        stack.append(name)
        for other in graph[name]:
            if other not in order:
                visit(other)
            if other in stack:
                lowest[name] = min(lowest[name], lowest[other])
        if lowest[name] == order[name]:
            at = stack.index(name)
            found.append(frozenset(stack[at:]))
            del stack[at:]

    for name in graph:
        if name not in order:
            visit(name)
    return [members for members in found if len(members) > 1]


def uses_of_robot(path: Path) -> Iterator[str]:
    """Where a module takes, keeps or is typed with a robot."""
    for node in nodes(path):
        if isinstance(node, ast.arg) and node.arg == "robot":
            yield f"{path}:{node.lineno}: a parameter called robot"
        if isinstance(node, ast.Attribute) and node.attr == "robot":
            yield f"{path}:{node.lineno}: an attribute called robot"
        if isinstance(node, ast.Name) and node.id in ("robot", "Robot"):
            yield f"{path}:{node.lineno}: {node.id}"
