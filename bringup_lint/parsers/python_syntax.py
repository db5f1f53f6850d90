"""The syntax tree of a Python file, and the way from positions of ``ast`` (lines, byte columns) to code points."""

from __future__ import annotations

import ast
import sys
import warnings
from typing import cast

from bringup_lint.model.python import PlacedNode
from bringup_lint.model.python import syntax_of
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

_LINE_END = regex(r"\r\n|\r|\n")


class Positions:
    """``shift`` code points of the source (a byte order mark) were not given to ``ast``."""

    def __init__(self, source: Source, shift: int) -> None:
        self.source = source
        text = source.text
        self._ascii = text.isascii()
        self._length = len(text)
        if "\r" in text:
            self._starts = [shift, *(match.end() for match in _LINE_END.finditer(text))]
        else:
            self._starts = list(source.line_starts)
            self._starts[0] = shift
        self._columns: dict[int, list[int] | None] = {}

    def offset(self, line: int, column: int) -> int:
        start = self._starts[min(line, len(self._starts)) - 1]
        if self._ascii:
            return start + column
        if line not in self._columns:
            self._columns[line] = self._table(line)
        table = self._columns[line]
        if table is None:
            return start + column
        return start + (table[column] if column < len(table) else len(table) and table[-1])

    def _table(self, line: int) -> list[int] | None:
        end = self._starts[line] if line < len(self._starts) else len(self.source.text)
        text = self.source.text[self._starts[line - 1] : end]
        if text.isascii():
            return None
        table: list[int] = []
        for at, char in enumerate(text):
            table += [at] * len(char.encode("utf-8", "surrogatepass"))
        table.append(len(text))
        return table

    def span(self, node: PlacedNode) -> Span:
        starts = self._starts
        last, column = node.end_lineno or node.lineno, node.end_col_offset or 0
        if self._ascii and last <= len(starts):
            start = starts[node.lineno - 1] + node.col_offset
            end = starts[last - 1] + column
        else:
            start = self.offset(node.lineno, node.col_offset)
            end = self.offset(last, column)
        if start <= end <= self._length:
            return Span(self.source, start, end)
        start = min(start, self._length)
        return Span(self.source, start, min(max(start, end), self._length))


def byte_order_mark(source: Source) -> int:
    """How many code points are before the text that ``ast`` is given."""
    return 1 if source.text.startswith("\ufeff") else 0


def syntax_tree(source: Source) -> tuple[ast.Module | None, list[Problem]]:
    """The tree of the text behind a byte order mark; the problem (``syntax``, or ``f-string`` inside of one)
    when it is not Python, or only that of newer releases."""
    shift = byte_order_mark(source)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(source.text[shift:]), []
    except SyntaxError as error:
        said = error.msg or ""
        tree = _newer(source.text[shift:])
        code = "f-string" if "f-string" in said or tree is not None else "syntax"
        return tree, [Problem(code, _place(source, error, shift), said)]
    except (ValueError, RecursionError, MemoryError) as error:
        return None, [Problem("syntax", source.whole, str(error))]


def _newer(text: str) -> ast.Module | None:
    """The tree of what only newer releases of Python read; None where it is something else."""
    from bringup_lint.parsers.newer_python import HOLDS
    from bringup_lint.parsers.newer_python import as_older

    older = as_older(text) if sys.version_info < (3, 12) and HOLDS.search(text) else text
    return syntax_of(older) if older != text else None


def kept_tree(source: Source) -> tuple[ast.Module | None, list[Problem]]:
    """As ``syntax_tree``, kept for all that ask for the syntax until ``python_node.let_go``."""
    return source.once(kept_tree, lambda: syntax_tree(source))


def tree_of(source: Source) -> ast.Module | None:
    """The tree for a question that needs it once: the one that is kept, where there is one."""
    kept = source.known(kept_tree)
    return cast("tuple[ast.Module | None, list[Problem]]", kept or syntax_tree(source))[0]


def imports(source: Source) -> tuple[ast.Import | ast.ImportFrom, ...]:
    """The imports that no ``try`` and no ``if`` surround, kept."""
    return source.once(imports, lambda: _imports(tree_of(source)))


def note_imports(source: Source, tree: ast.Module) -> None:
    """Keep the imports of a tree, for which the file is then not read again."""
    source.once(imports, lambda: _imports(tree))


def _imports(tree: ast.Module | None) -> tuple[ast.Import | ast.ImportFrom, ...]:
    body = tree.body if tree is not None else ()
    return tuple(each for each in body if isinstance(each, (ast.Import, ast.ImportFrom)))


def _place(source: Source, error: SyntaxError, shift: int) -> Span:
    """Where Python stopped reading; to the end of that line."""
    starts = source.line_starts
    line = min(max(error.lineno or 1, 1), len(starts))
    width = len(source.line_text(line))
    column = min(max((error.offset or 1) - 1 + (shift if line == 1 else 0), 0), width)
    start = starts[line - 1] + column
    return Span(source, start, max(start, starts[line - 1] + width))


def located(value: str, span: Span) -> Located:
    """A string constant with its place: between the quotes when what is there is the value itself."""
    text = span.source.text
    start, end = span.start, span.end
    size = end - start - len(value)
    if size == 2 and text.startswith(value, start + 1):
        return Located(value, Span(span.source, start + 1, end - 1))
    if size == 3 and text[start] in "rRuUbBfF" and text.startswith(value, start + 2):
        return Located(value, Span(span.source, start + 2, end - 1))
    if size == 6 and text.startswith(value, start + 3):
        return Located(value, Span(span.source, start + 3, end - 3))
    return Located(value, span)
