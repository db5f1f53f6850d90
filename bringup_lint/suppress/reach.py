"""Which lines a comment above them counts for: the next statement, to its last line.

A comment cannot be written inside a tag, a continued line, a text block or a here-document (``unbroken``), so the one
above counts for all of it. Lines are counted from 1.
"""

from __future__ import annotations

from bringup_lint.parsers.yaml_kinds import YAML_KINDS
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.suppress.forms import starts_of
from bringup_lint.suppress.unbroken import unbroken

LIMIT = 500
"""Lines: no longer statement is looked for below one that only looks like one."""
_PROLOG = regex(
    r"#!|<\?|<!DOCTYPE|---|%(?:YAML|TAG)\b|#cloud-config|## *template:|# *(?:syntax|escape|check) *=|# *-\*-|\ufeff"
    r"|#[^\n]{0,80}coding[:=]"
)
_YAML_LINE = regex(
    r"(?P<lead> *(?:- +)*)"
    r"(?P<key>(?:[^\s#\[{\"'][^\n#]*?|[\"'][^\"'\n]*[\"']):(?:[ \t]+|$))?"
    r"(?P<value>[^\s#]?)"
)


def is_comment(source: Source, line: int) -> bool:
    return source.line_text(line).lstrip().startswith(starts_of(source))


def head_end(source: Source) -> int:
    """The last line above which nothing but comments, blanks and what must be first, such as ``<?xml ...?>``."""
    line, last = 1, min(len(source.line_starts), LIMIT)
    while line <= last and _is_head(source, line):
        line = unbroken(source).around(line).stop
    return line - 1


def prolog_end(source: Source) -> int:
    """The last line of what must be first, such as ``<?xml ...?>``; 0 where there is none."""
    lines = range(1, head_end(source) + 1)
    last = max((line for line in lines if _PROLOG.match(source.line_text(line))), default=0)
    return unbroken(source).around(last).stop - 1


def _is_head(source: Source, line: int) -> bool:
    text = source.line_text(line)
    return not text.strip() or bool(_PROLOG.match(text)) or is_comment(source, line)


def statement_after(source: Source, line: int, known: dict[int, int]) -> range:
    """The lines below a comment that ends on ``line``: further comments, and then one statement.

    ``known`` remembers where the statement below each line ends, so that comments in a row are passed once.
    """
    first = at = line + 1
    if first > len(source.line_starts):
        return range(0)
    if first not in known:
        last = min(len(source.line_starts), line + LIMIT)
        while at < last and is_comment(source, at):
            at += 1
        known.update(dict.fromkeys(range(first, at + 1), max(at, statement_end(source, at)) + 1))
    return range(first, known[first])


def statement_end(source: Source, line: int) -> int:
    """The last line of what begins on ``line`` and cannot be interrupted by a comment."""
    around = unbroken(source).around(line)
    end = max(_continued(source, line), around.stop - 1 if around.start == line else line)
    return max(end, _scalar_end(source, line)) if source.kind in YAML_KINDS else end


def _continued(source: Source, line: int) -> int:
    """The last of the lines that backslashes join."""
    last = min(len(source.line_starts), line + LIMIT)
    while line < last and (source.line_text(line).endswith("\\") or is_comment(source, line)):
        line += 1
    return line


def _scalar_end(source: Source, line: int) -> int:
    """The last line of a YAML scalar: those that are further to the right than its key or dash."""
    text = source.line_text(line)
    shape = _YAML_LINE.match(text)
    if shape is None or not shape["value"] or not (shape["key"] or shape["lead"].strip()):
        return line
    column = len(shape["lead"]) if shape["key"] else shape["lead"].rfind("-")
    end = at = line
    while at < min(len(source.line_starts), line + LIMIT):
        at += 1
        below = source.line_text(at)
        if below.strip() and len(below) - len(below.lstrip(" ")) <= column:
            break
        end = at if below.strip() else end
    return end
