"""Places in a text as the protocol counts them: lines and columns from 0, columns in UTF-16 code units or as agreed."""

from __future__ import annotations

from bisect import bisect_right
from functools import cached_property

from lsprotocol.types import Position
from lsprotocol.types import PositionEncodingKind
from lsprotocol.types import Range

from bringup_lint.pattern import regex

_LINE_END = regex(r"\r\n|\n|\r")
_UNITS = {PositionEncodingKind.Utf8: ("utf-8", 1), PositionEncodingKind.Utf16: ("utf-16-le", 2)}
"""How a text is encoded to count its units, and the bytes of a unit."""
_BOM = "\ufeff"


class Positions:
    """The places of one text. A byte order mark at its start is not part of what an editor shows."""

    def __init__(self, text: str, encoding: PositionEncodingKind | str = PositionEncodingKind.Utf16) -> None:
        self.text = text
        self.codec = _UNITS.get(PositionEncodingKind(encoding))
        self.first = len(_BOM) if text.startswith(_BOM) else 0

    @cached_property
    def _starts(self) -> list[int]:
        return [self.first, *(end.end() for end in _LINE_END.finditer(self.text))]

    @cached_property
    def _ends(self) -> list[int]:
        return [*(end.start() for end in _LINE_END.finditer(self.text)), len(self.text)]

    def position(self, offset: int) -> Position:
        """The place of a code point."""
        offset = max(offset, self.first)
        line = bisect_right(self._starts, offset) - 1
        return Position(line, self._units(self.text[self._starts[line] : offset]))

    def range(self, start: int, end: int) -> Range:
        return Range(self.position(start), self.position(end))

    @property
    def whole(self) -> Range:
        return self.range(0, len(self.text))

    def offset(self, position: Position) -> int:
        """The code point at a place; a place after the end of a line or of the text means that end."""
        if position.line >= len(self._starts):
            return len(self.text)
        start, end = self._starts[position.line], self._ends[position.line]
        line = self.text[start:end]
        if self.codec is None:
            return min(start + position.character, end)
        codec, size = self.codec
        before = line.encode(codec, "surrogatepass")[: position.character * size]
        return start + len(before.decode(codec, "ignore"))

    def _units(self, text: str) -> int:
        if self.codec is None or text.isascii():
            return len(text)
        codec, size = self.codec
        return len(text.encode(codec, "surrogatepass")) // size
