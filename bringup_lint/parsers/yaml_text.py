"""Where the characters of a YAML scalar are in the text: quotes, escapes, folds and indentation undone."""

from __future__ import annotations

import re

from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

PROPERTIES = regex(r"(?:[&!]\S*(?:\s|#[^\n]*\n)*)+")
BLOCK_HEADER = regex(r"[|>][^\n]*(?:\r\n|[\n\r\x85\u2028\u2029]|\Z)")
BREAK = regex(r"\r\n|[\n\r\x85\u2028\u2029]")
FOLD = regex(r"[ \t]*(?:(?:\r\n|[\n\r\x85\u2028\u2029])[ \t]*)+")
ESCAPE_LENGTH = {"x": 4, "u": 6, "U": 10}

Pieces = list[tuple[int, int]]


def content(source: Source, start: int, end: int, value: str, style: str, named: bool) -> tuple[Located, Span]:
    """The located value and the whole span of a scalar that libyaml saw between two offsets.

    ``named`` tells that an anchor or a tag is before it, which the whole span leaves out.
    """
    text = source.text
    if not (style or named) and text[start:end] == value:
        whole = Span(source, start, end)
        return Located(value, whole), whole
    if named and (match := PROPERTIES.match(text, start, end)):
        start = match.end()
    if style in ("|", ">"):
        return _block(source, start, end, value)
    whole = Span(source, start, end)
    quote = 1 if style in ("'", '"') and end - start >= 2 else 0
    inner = Span(source, start + quote, end - quote)
    if text[inner.start : inner.end] == value:
        return Located(value, inner), whole
    return Located(value, inner, _pieces(_flow(text, inner, value, style))), whole


def _pieces(pairs: Pieces | None) -> tuple[tuple[int, int], ...] | None:
    """Only the places where the distance between value and text changes."""
    if not pairs:
        return None
    kept = [pairs[0]]
    for inside, outside in pairs[1:]:
        if outside - inside != kept[-1][1] - kept[-1][0]:
            kept.append((inside, outside))
    return tuple(kept)


def _flow(text: str, span: Span, value: str, style: str) -> Pieces | None:
    """Align a plain or quoted scalar; None when the two don't fit."""
    pairs: Pieces = []
    at, end, done, length = span.start, span.end, 0, len(value)
    while at < end and done < length:
        fold = FOLD.match(text, at, end)
        if fold:
            breaks = len(BREAK.findall(fold[0]))
            count = max(1, breaks - 1)
            pairs.extend((done + i, at) for i in range(min(count, length - done)))
            done += count
            at = fold.end()
            continue
        pairs.append((done, at))
        char = text[at]
        if style == '"' and char == "\\":
            broken = FOLD.match(text, at + 1, end) if BREAK.match(text, at + 1, end) else None
            if broken:
                pairs.pop()
                at = broken.end()
                extra = len(BREAK.findall(broken[0])) - 1
                pairs.extend((done + i, at - 1) for i in range(min(extra, length - done)))
                done += extra
                continue
            at += ESCAPE_LENGTH.get(text[at + 1 : at + 2], 2)
        elif style == "'" and text.startswith("''", at):
            at += 2
        elif char == value[done] or value[done] == "\ufffd":
            at += 1
        else:
            return None
        done += 1
    return pairs if done == length else None


def _block(source: Source, start: int, end: int, value: str) -> tuple[Located, Span]:
    """Align a block scalar, whose span ends with its last character that is no line end or blank."""
    text = source.text
    header = BLOCK_HEADER.match(text, start, end)
    first = header.end() if header else start
    last = first + len(text[first:end].rstrip("\r\n\x85\u2028\u2029 \t"))
    whole = Span(source, start, max(start + 1, last))
    if not value:
        return Located("", Span(source, last, last)), whole
    pairs: Pieces = []
    at, done, indent = first, 0, _indentation(text, first, end, value)
    fresh = True
    while at < end and done < len(value):
        if fresh:
            blank = at
            while at < end and at - blank < indent and text[at] == " ":
                at += 1
            fresh = False
            continue
        line_end = BREAK.match(text, at, end)
        if line_end:
            if value[done] in "\n \x85\u2028\u2029":
                pairs.append((done, at))
                done += 1
            at = line_end.end()
            fresh = True
        elif text[at] == value[done] or value[done] == "\ufffd":
            pairs.append((done, at))
            at += 1
            done += 1
        else:
            pairs = []
            break
    inner = Span(source, pairs[0][1] if pairs else first, max(last, first))
    return Located(value, inner, _pieces(pairs)), whole


def _indentation(text: str, first: int, end: int, value: str) -> int:
    """Blanks before the first line with a character, less those that the value keeps."""
    line = first
    while line < end and (match := re.compile(r" *(?=[\r\n\x85\u2028\u2029])").match(text, line, end)):
        line_end = BREAK.match(text, match.end(), end)
        if line_end is None:
            break
        line = line_end.end()
    written = len(text[line:end]) - len(text[line:end].lstrip(" "))
    stripped = value.lstrip("\n")
    return max(0, written - (len(stripped) - len(stripped.lstrip(" "))))
