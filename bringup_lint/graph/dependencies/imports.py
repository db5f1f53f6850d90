"""The modules that Python files import whenever they are loaded."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.parsers.python_syntax import imports
from bringup_lint.source import Located
from bringup_lint.source import Source


def imported(source: Source, package: str | None = None) -> Iterator[Located]:
    """The modules of the imports that no ``try`` and no ``if`` surround, with full names. Each has the span of its
    line. Relative ones count where the package is known that the file lies in, with dots. Each file is read once."""
    yield from source.once((imported, package), lambda: tuple(_imported(source, package)))


def _imported(source: Source, package: str | None) -> Iterator[Located]:
    for statement in imports(source):
        if isinstance(statement, ast.Import):
            names = [each.name for each in statement.names]
        else:
            names = [_absolute(statement, package)]
        start = source.line_starts[statement.lineno - 1]
        span = source.span(start, start + len(source.line_text(statement.lineno)))
        yield from (Located(name, span) for name in names if name)


def _absolute(statement: ast.ImportFrom, package: str | None) -> str:
    if not statement.level:
        return statement.module or ""
    parts = package.split(".") if package is not None else []
    above = parts[: len(parts) - statement.level + 1]
    return ".".join([*above, *([statement.module] if statement.module else [])]) if above else ""
