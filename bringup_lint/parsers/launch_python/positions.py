"""From the positions of ``ast`` (lines, UTF-8 byte columns) to code point offsets."""

from __future__ import annotations

import ast
import re

from bringup_lint.source import Source
from bringup_lint.source import Span

_LINE_END = re.compile(r"\r\n|\r|\n")


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

    def span(self, node: ast.expr | ast.stmt | ast.keyword | ast.arg | ast.excepthandler) -> Span:
        starts = self._starts
        if self._ascii and node.end_lineno <= len(starts):
            start = starts[node.lineno - 1] + node.col_offset
            end = starts[node.end_lineno - 1] + node.end_col_offset
        else:
            start = self.offset(node.lineno, node.col_offset)
            end = self.offset(node.end_lineno, node.end_col_offset)
        if start <= end <= self._length:
            return Span(self.source, start, end)
        start = min(start, self._length)
        return Span(self.source, start, min(max(start, end), self._length))
