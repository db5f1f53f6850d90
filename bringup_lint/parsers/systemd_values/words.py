"""Splitting a value into words, with the quotes and escapes of systemd.syntax(7); every word keeps its place."""

from __future__ import annotations

from typing import NamedTuple

from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

BLANKS = " \t\n\r"
_SIMPLE = {
    "a": "\a", "b": "\b", "f": "\f", "n": "\n", "r": "\r", "t": "\t", "v": "\v", "s": " ",
    "\\": "\\", '"': '"', "'": "'",
}  # fmt: skip
_HEXADECIMAL = set("0123456789abcdefABCDEF")
_DIGITS = {"x": (2, 16), "u": (4, 16), "U": (8, 16)}

DROP = "drop"
"""A backslash makes the next character literal and goes away."""
KEEP = "keep"
"""A backslash is a character like any other."""
DECODE = "decode"
"""C escapes are decoded; an unknown one spoils the value."""
DECODE_RELAXED = "decode-relaxed"
"""C escapes are decoded; an unknown one stays as it is and is reported."""


class Extracted(NamedTuple):
    """One word, where the next one starts (-1 at the end), and what was wrong."""

    word: Located | None
    next: int
    problems: tuple[ValueProblem, ...] = ()
    broken: bool = False


def decode_escape(text: str, at: int) -> tuple[str, int] | None:
    """The character that the escape at ``text[at]`` (after its backslash) stands for, and where it ends."""
    head = text[at : at + 1]
    if head in _SIMPLE and head:
        return _SIMPLE[head], at + 1
    if head in _DIGITS and head:
        count, base = _DIGITS[head]
        start = at + 1
    elif head and head in "01234567":
        count, base, start = 3, 8, at
    else:
        return None
    digits = text[start : start + count]
    if len(digits) != count or not set(digits) <= _HEXADECIMAL or (base == 8 and not set(digits) <= set("01234567")):
        return None
    code = int(digits, base)
    limit = 255 if base == 8 else 0x10FFFF
    if not 0 < code <= limit or 0xD800 <= code <= 0xDFFF:
        return None
    return chr(code), start + count


def _located(value: Located, pieces: list[tuple[int, int, str]], start: int, end: int) -> Located:
    """The word made of ``pieces`` (offset in the value, length there, text), standing at ``start:end``."""
    place = value.part(start, end)
    if len(pieces) == 1 and pieces[0][1] == end - start == len(pieces[0][2]):
        return place
    text = "".join(piece for _, _, piece in pieces)
    mapping: list[tuple[int, int]] = []
    out = 0
    for offset, _, piece in pieces:
        if piece:
            mapping.append((out, value.origin(offset)))
            mapping.extend(
                (out + inner - offset, outer)
                for inner, outer in value.pieces or ()
                if offset < inner < offset + len(piece)
            )
            out += len(piece)
    first = place.span.start
    if not mapping or mapping[0][0] != 0:
        mapping.insert(0, (0, first))
    return Located(text, place.span, tuple(mapping))


def extract(
    value: Located,
    at: int = 0,
    *,
    separators: str = BLANKS,
    quotes: bool = True,
    escapes: str = DECODE,
    coalesce: bool = True,
) -> Extracted:
    """The first word at or after ``at``. Without ``coalesce`` every single separator ends a (maybe empty) word."""
    text: str = value  # str(value) would copy the whole line for each word
    size = len(text)
    if at < 0 or at > size:
        return Extracted(None, -1)
    if coalesce:
        while at < size and text[at] in separators:
            at += 1
        if at >= size:
            return Extracted(None, -1)
    elif at >= size:
        return Extracted(value.part(size, size), -1)
    start = at
    pieces: list[tuple[int, int, str]] = []
    problems: list[ValueProblem] = []
    quote = ""
    quoted_from = 0
    run = at
    while at < size:
        char = text[at]
        if char == "\\" and escapes != KEEP:
            if at > run:
                pieces.append((run, at - run, text[run:at]))
            if at + 1 >= size:
                if escapes == DECODE_RELAXED and not quote:
                    pieces.append((at, 1, "\\"))
                    run = at = size
                    break
                return Extracted(
                    value.part(start, size), -1, (ValueProblem("unknown-escape", value.part(at, size)),), True
                )
            if escapes == DROP:
                pieces.append((at, 2, text[at + 1]))
                at += 2
            else:
                decoded = decode_escape(text, at + 1)
                if decoded is not None:
                    pieces.append((at, decoded[1] - at, decoded[0]))
                    at = decoded[1]
                else:
                    bad = ValueProblem("unknown-escape", value.part(at, at + 2), suggestion="\\" + text[at : at + 2])
                    problems.append(bad)
                    if escapes == DECODE:
                        return Extracted(value.part(start, size), -1, tuple(problems), True)
                    pieces.append((at, 2, text[at : at + 2]))
                    at += 2
            run = at
        elif quotes and (char == quote if quote else char in "'\""):
            if at > run:
                pieces.append((run, at - run, text[run:at]))
            quote, quoted_from = ("", 0) if quote else (char, at)
            at += 1
            run = at
        elif not quote and char in separators:
            break
        else:
            at += 1
    if quote:
        bad = ValueProblem("unbalanced-quotes", value.part(quoted_from, size))
        return Extracted(value.part(start, size), -1, (bad,), True)
    if at > run:
        pieces.append((run, at - run, text[run:at]))
    word = _located(value, pieces, start, at) if pieces else Located("", value.part(start, at).span)
    if at >= size:
        return Extracted(word, -1, tuple(problems))
    if not coalesce:
        return Extracted(word, at + 1, tuple(problems))
    while at < size and text[at] in separators:
        at += 1
    return Extracted(word, at if at < size else -1, tuple(problems))


class Words(NamedTuple):
    words: tuple[Located, ...]
    problems: tuple[ValueProblem, ...]
    broken: bool
    """The last word could not be read; what stands before it counts."""


def split_words(
    value: Located,
    *,
    separators: str = BLANKS,
    quotes: bool = True,
    escapes: str = DROP,
    coalesce: bool = True,
) -> Words:
    """All words of a value, quotes removed; stops at the first word that cannot be read."""
    if (
        coalesce
        and separators == BLANKS
        and "\\" not in value
        and (not quotes or ("'" not in value and '"' not in value))
    ):
        return Words(tuple(value.words()), (), False)
    return _collect(value, separators, quotes, escapes, coalesce)


def _collect(value: Located, separators: str, quotes: bool, escapes: str, coalesce: bool) -> Words:
    words: list[Located] = []
    problems: list[ValueProblem] = []
    at = 0
    while at >= 0:
        found = extract(value, at, separators=separators, quotes=quotes, escapes=escapes, coalesce=coalesce)
        problems += found.problems
        if found.broken:
            return Words(tuple(words), tuple(problems), True)
        if found.word is None:
            break
        words.append(found.word)
        at = found.next
    return Words(tuple(words), tuple(problems), False)


def nowhere(text: str) -> Located:
    """A value that stands in no file, for callers that only have a string."""
    source = Source("", text)
    return Located(text, Span(source, 0, len(text)))
