"""Text that knows where it is: Source, Span and Located values."""

from __future__ import annotations

import os
import re
from bisect import bisect_right
from collections.abc import Callable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.ignore_marks import without_marks
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.type_names import Any
from bringup_lint.type_names import TypeVar
from bringup_lint.type_names import cast

Made = TypeVar("Made")

_WORD = regex(r"[^ \t\n\r\f\v]+")
_NEAR = 2_000
"""Characters of a line before a place that are looked at."""
_REMARKS = regex(r"(?m)^[ \t]*#[^\n]*")
"""Lines of a comment."""


class Position(NamedTuple):
    """A place in a text, as people count: lines and columns start at 1, columns count code points."""

    line: int
    column: int


@dataclass(eq=False, slots=True)
class Source:
    """One file as it was read; nothing ever reads it from disk again."""

    name: str
    """The path shown to the user: relative to the working folder when it lies below it."""
    text: str = ""
    kind: str = ""
    """What the file is (see ``discover.kinds``), e.g. ``systemd-unit``; empty when nothing claimed it."""
    robot_path: str | None = None
    """The absolute path on the robot (``/etc/...``), when the tree tells it."""
    judged: bool = True
    """False for context, such as the vendor's units beside a checked ``/etc``: read, never reported on."""
    template: str = ""
    """The template language (``jinja``, ``m4``, ``empy``, ``cmake``) when the text is not final, else empty."""
    mode: int | None = None
    """Permission bits, when they are real (a root file system); None in a checkout."""
    virtual: bool = False
    """Text that is not a file, such as a running graph; ``name`` then says what it is, in angle brackets."""
    link: str | None = None
    """Where the symbolic link points, as written in it; None for a plain file."""
    uid: int | None = None
    gid: int | None = None
    masked: bool = False
    """Whether secrets in the text are hidden, so that it is not what the file holds."""
    origin: Origin | None = None
    """Where the text comes from when another file of the tree writes this one."""
    models: dict[object, object] | None = field(default=None, init=False)
    """Parser -> the model that it made of this text, where a source outlives a run; None where it does not."""
    _made: dict[object, object] | None = field(default=None, init=False)
    _said: str | None = field(default=None, init=False)
    _line_starts: list[int] | None = field(default=None, init=False)
    _absolute: str | None = field(default=None, init=False)

    def kept(self, key: object, make: Callable[[], Made]) -> Made:
        """What ``make`` makes of this text alone; made once where the source outlives a run."""
        if self.models is None:
            return make()
        known = cast("dict[object, Made]", self.models)
        if key not in known:
            known[key] = make()
        return known[key]

    def once(self, key: object, make: Callable[[], Made]) -> Made:
        """What ``make`` makes of this text alone, for all that ask in this run."""
        made: Any = self._made if self.models is None else self.models
        if made is None:
            made = self._made = {}
        if key not in made:
            made[key] = make()
        answer: Made = made[key]
        return answer

    def known(self, key: object) -> object:
        """What ``once`` made in this run, or in an earlier one; None where nobody asked yet."""
        made = self._made if self.models is None else self.models
        return made.get(key) if made else None

    def forget(self, key: object) -> object:
        """What was made for all that ask in this run, which is made again for whoever asks later; None where there is
        nothing, or the source outlives the run."""
        return self._made.pop(key, None) if self._made else None

    def matches(self, pattern: re.Pattern[str]) -> bool:
        """Whether the text has a match of a pattern that a module holds; searched once for all that ask."""
        return self.once(pattern, lambda: pattern.search(self.text) is not None)

    def says(self, pattern: re.Pattern[str]) -> bool:
        """As ``matches``, for the text without the comments that silence rules."""
        return self.once((Source.says, pattern), lambda: pattern.search(self.said) is not None)

    @property
    def said(self) -> str:
        """The text as rules search it: blanks are written over the comments that silence them, and offsets stay."""
        if self._said is None:
            self._said = without_marks(self.text)
        return self._said

    @property
    def uncommented(self) -> str:
        """The text without the lines that are comments of Python, shells and CMake; offsets do not stay."""
        return self.once(_REMARKS, lambda: _REMARKS.sub("", self.text))

    @property
    def line_starts(self) -> list[int]:
        """The offset of the first character of each line."""
        if self._line_starts is None:
            self._line_starts = self._starts()
        return self._line_starts

    def _starts(self) -> list[int]:
        starts = [0]
        find = self.text.find
        at = find("\n")
        while at != -1:
            starts.append(at + 1)
            at = find("\n", at + 1)
        return starts

    def position(self, offset: int) -> Position:
        line = bisect_right(self.line_starts, offset)
        return Position(line, offset - self.line_starts[line - 1] + 1)

    def line_text(self, line: int) -> str:
        """The text of a line, counted from 1, without its line end."""
        starts = self.line_starts
        end = starts[line] if line < len(starts) else len(self.text)
        return self.text[starts[line - 1] : end].rstrip("\r\n")

    def comments_at(self, line: int) -> list[str]:
        """The comments with # right above a line, and what follows a # on it."""
        found = [self.line_text(line).partition("#")[2]]
        while line > 1 and self.line_text(line - 1).lstrip().startswith("#"):
            line -= 1
            found.append(self.line_text(line))
        return found[::-1]

    def line_before(self, offset: int) -> str:
        """The text of a line before an offset in it; of a very long line only what is near."""
        near = max(0, offset - _NEAR)
        return self.text[max(near, self.text.rfind("\n", near, offset) + 1) : offset]

    @property
    def absolute(self) -> str:
        """The absolute path of the file, from the folder in which the run began."""
        if self._absolute is None:
            self._absolute = os.path.abspath(self.name)
        return self._absolute

    def span(self, start: int, end: int) -> Span:
        return Span(self, start, end)

    def located(self, start: int, end: int) -> Located:
        return Located(self.text[start:end], Span(self, start, end))

    @property
    def whole(self) -> Span:
        """Stands for the file itself, when no line of it is to blame."""
        return Span(self, 0, 0)

    @property
    def basename(self) -> str:
        return self.name.rpartition("/")[2]


class Span(NamedTuple):
    """A stretch of a source: code point offsets, ``end`` exclusive."""

    source: Source
    start: int
    end: int

    @property
    def path(self) -> str:
        return self.source.name

    @property
    def line(self) -> int:
        return self.source.position(self.start).line

    @property
    def column(self) -> int:
        return self.source.position(self.start).column

    @property
    def end_position(self) -> Position:
        """Where the stretch ends, exclusive, on the line of its last character."""
        if self.end <= self.start:
            return self.source.position(self.start)
        line, column = self.source.position(self.end - 1)
        return Position(line, column + 1)

    @property
    def text(self) -> str:
        return self.source.text[self.start : self.end]

    def holds(self, inner: Span) -> bool:
        """Whether another stretch lies inside this one."""
        return self.source is inner.source and self.start <= inner.start and inner.end <= self.end


class Piece(NamedTuple):
    """From ``at`` on, a text comes from a stretch of another; both go on side by side unless something was expanded."""

    at: int
    start: int
    end: int


@dataclass(frozen=True, eq=False)
class Origin:
    """Where the text of a file comes from that another file writes, such as a here-document of a script."""

    whole: Span
    """What writes the file."""
    pieces: tuple[Piece, ...]
    """Ascending, from the first character on."""
    certain: bool = True
    """Whether it is surely written: not only under a condition."""
    verbatim: bool = False
    """Whether an edit of the text is the same edit there."""

    def span(self, start: int, end: int) -> Span:
        """The stretch of the writing file that a stretch of the text comes from."""
        if not self.pieces or end <= 0:
            return self.whole
        first = self._place(start, 0)
        return Span(self.whole.source, first, max(first, self._place(end - 1, 1) if end > start else first))

    def _place(self, at: int, after: int) -> int:
        number = max(bisect_right(self.pieces, (at, float("inf"))) - 1, 0)
        piece = self.pieces[number]
        length = self.pieces[number + 1].at - piece.at if number + 1 < len(self.pieces) else piece.end - piece.start
        if length == piece.end - piece.start:
            return min(piece.start + max(at - piece.at, 0) + after, piece.end)
        return piece.end if after else piece.start


_new = str.__new__


class Located(str):
    """A string with its span. Where text and source differ (continued lines, removed quotes), ``pieces`` maps one
    to the other: pairs of (offset in the string, offset in the source), ascending."""

    __slots__ = ("pieces", "span")

    span: Span
    pieces: tuple[tuple[int, int], ...] | None

    def __new__(cls, text: str, span: Span, pieces: tuple[tuple[int, int], ...] | None = None) -> Located:
        self = _new(cls, text)
        self.span = span
        self.pieces = pieces
        return self

    def __reduce__(self) -> tuple[type[Located], tuple[str, Span, tuple[tuple[int, int], ...] | None]]:
        return (Located, (str(self), self.span, self.pieces))

    def origin(self, index: int) -> int:
        """Offset in the source of the character at ``index``."""
        if self.pieces is None:
            return min(self.span.start + index, self.span.end)
        at = bisect_right(self.pieces, (index, float("inf"))) - 1
        inner, outer = self.pieces[max(at, 0)]
        return outer + index - inner

    def part(self, start: int, end: int) -> Located:
        """The characters from ``start`` to ``end``, with their own span."""
        source, opens, closes = self.span
        if end <= start:
            at = self.origin(start)
            return Located("", Span(source, at, at))
        text = self[start:end]
        if self.pieces is None and opens + end <= closes:
            found = _new(Located, text)
            found.span, found.pieces = Span(source, opens + start, opens + end), None
            return found
        first = self.origin(start)
        last = self.origin(end - 1) + 1
        if self.pieces is None or last - first == end - start:
            return Located(text, Span(source, first, last))
        inside = tuple((i - start, o) for i, o in self.pieces if start < i < end)
        return Located(text, Span(source, first, last), ((0, first), *inside))

    def strip_located(self, chars: str | None = None) -> Located:
        """Like ``str.strip``, keeping the place."""
        length = len(self)
        if len(self.strip(chars)) == length and self.is_verbatim:
            return self
        start = length - len(self.lstrip(chars))
        return self.part(start, max(start, len(self.rstrip(chars))))

    @property
    def is_verbatim(self) -> bool:
        """Whether this is what the source holds there, character by character."""
        return self.pieces is None and len(self) == self.span.end - self.span.start

    def words(self) -> Iterator[Located]:
        """The words between blanks of ASCII, each with its place: other blanks belong to a word, as C reads it."""
        if _WORD.fullmatch(self) and type(self) is Located and self.is_verbatim:
            yield self
            return
        for match in _WORD.finditer(self):
            yield self.part(*match.span())

    @property
    def line(self) -> int:
        return self.span.line

    @property
    def path(self) -> str:
        return self.span.path


@dataclass(frozen=True, slots=True)
class Problem:
    """What a parser could not read: a stable code (``missing-equals``), the place, and what is known about it."""

    code: str
    where: Located | Span
    detail: str = ""

    @property
    def span(self) -> Span:
        return self.where.span if isinstance(self.where, Located) else self.where

    @property
    def word(self) -> Located:
        """The place with its text."""
        return self.where if isinstance(self.where, Located) else Located(self.where.text, self.where)
