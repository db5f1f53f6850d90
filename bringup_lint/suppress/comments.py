"""Reading the comments: ``bringup-lint: ignore[systemd/root-user]: why`` and ``ignore-file[...]``.

`` -- why`` says the same, where the format allows it: an XML comment cannot hold two hyphens.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator
from itertools import islice

from bringup_lint.dataclass import dataclass
from bringup_lint.ignore_marks import IGNORE
from bringup_lint.ignore_marks import OPENS
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.suppress.reach import head_end
from bringup_lint.suppress.reach import statement_after

_SEPARATORS = ("--", ":", "–", "—")
LIMIT = 5000
"""Comments of one file that are read."""


@dataclass(eq=False)
class Ignore:
    """One name in one comment."""

    name: Located
    reason: str
    lines: range | None
    """The lines it counts for; None for the whole file."""
    head: bool
    """Whether it is above everything else, and so counts for what is said of the file as a whole."""
    used: bool = False


class _Comment(NamedTuple):
    """What one comment says, and where: the offset of the mark, the line that it ends on."""

    match: re.Match[str]
    reason: str
    own_line: bool
    end_line: int


def read(source: Source) -> Iterator[Ignore]:
    """Every name in every suppression comment of a file."""
    head = head_end(source)
    ends: dict[int, int] = {}
    for comment in _comments(source):
        line = source.position(comment.match.start()).line
        first = comment.own_line and line <= head
        lines = _lines(source, comment, line, first, ends)
        names = source.located(*comment.match.span("names"))
        for part in re.finditer(r"[^,\s]+", names):
            yield Ignore(names.part(*part.span()), comment.reason, lines, first)


def _lines(source: Source, comment: _Comment, line: int, first: bool, ends: dict[int, int]) -> range | None:
    if comment.match["what"] == "ignore-file":
        return None
    if not comment.own_line:
        return range(line, line + 1)
    below = statement_after(source, comment.end_line, ends)
    return range(1, below.stop) if first else below


def _comments(source: Source) -> Iterator[_Comment]:
    """The comments, each stretch of the text looked at once."""
    text = source.text
    ends = [match.start() for match in re.finditer("-->", text)]
    marks = list(islice(IGNORE.finditer(text), LIMIT))
    own_line: dict[int, bool] = {}
    for at, match in enumerate(marks):
        line = source.position(match.start()).line
        start = source.line_starts[line - 1]
        before = text[max(start, marks[at - 1].end() if at else 0) : match.start()].rstrip()
        opens = next((sign for sign in OPENS if before.endswith(sign)), None)
        if opens is None:
            continue
        alone = own_line.setdefault(line, not before.removesuffix(opens).strip())
        stop = source.line_starts[line] if line < len(source.line_starts) else len(text)
        if at + 1 < len(marks):
            stop = min(stop, marks[at + 1].start())
        closed = bisect_left(ends, match.end()) if opens == "<!--" else len(ends)
        end_line = source.position(ends[closed]).line if closed < len(ends) else line
        yield _Comment(match, _reason(text[match.end() : stop]), alone, end_line)


def _reason(text: str) -> str:
    """The reason in what follows the names; empty when there is none."""
    said = text.partition("-->")[0].strip()
    return said.lstrip("-:–— \t") if said.startswith(_SEPARATORS) else ""
