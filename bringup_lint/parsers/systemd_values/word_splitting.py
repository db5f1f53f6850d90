"""Splitting a value into words, with the quotes and escapes of systemd.syntax(7); every word keeps its place."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

BLANKS = " \t\n\r"
_SIMPLE = {
    "a": "\a", "b": "\b", "f": "\f", "n": "\n", "r": "\r", "t": "\t", "v": "\v", "s": " ",
    "\\": "\\", '"': '"', "'": "'",
}  # fmt: skip
_ORDINARY = regex(r"[^\\'\" \t\n\r]+")
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


class _Escape(NamedTuple):
    """A backslash and what follows it."""

    text: str
    next: int
    problem: ValueProblem | None = None
    spoils: bool = False
    """The value cannot be read because of it."""


def _escape(value: Located, at: int, escapes: str, quoted: bool) -> _Escape:
    text: str = value
    if at + 1 >= len(text):
        lone = escapes == DECODE_RELAXED and not quoted
        bad = None if lone else ValueProblem("unknown-escape", value.part(at, len(text)))
        return _Escape("\\", at + 1, bad, not lone)
    if escapes == DROP:
        return _Escape(text[at + 1], at + 2)
    decoded = decode_escape(text, at + 1)
    if decoded is not None:
        return _Escape(*decoded)
    bad = ValueProblem("unknown-escape", value.part(at, at + 2), suggestion="\\" + text[at : at + 2])
    return _Escape(text[at : at + 2], at + 2, bad, escapes == DECODE)


def _after(text: str, at: int, separators: str) -> int:
    """The end of the separators at an offset."""
    while at < len(text) and text[at] in separators:
        at += 1
    return at


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
    start = _after(text, at, separators) if coalesce else at
    if start >= size:
        return Extracted(None if coalesce else value.part(size, size), -1)
    word, end, problems, broken = _word(value, start, separators, quotes, escapes)
    if broken or end >= size:
        return Extracted(word, -1, problems, broken)
    following = _after(text, end, separators) if coalesce else end + 1
    return Extracted(word, following if following < size or not coalesce else -1, problems)


def _word(
    value: Located, start: int, separators: str, quotes: bool, escapes: str
) -> tuple[Located, int, tuple[ValueProblem, ...], bool]:
    """The word that starts at an offset, its end, what is wrong with it, and whether it cannot be read."""
    text: str = value
    size = len(text)
    pieces: list[tuple[int, int, str]] = []
    problems: list[ValueProblem] = []
    quote, quoted_from = "", 0
    run = at = start
    while at < size:
        char = text[at]
        if char == "\\" and escapes != KEEP:
            _end_run(pieces, text, run, at)
            escape = _escape(value, at, escapes, bool(quote))
            if escape.problem is not None:
                problems.append(escape.problem)
            if escape.spoils:
                lone = (escape.problem,) if at + 1 >= size and escape.problem is not None else tuple(problems)
                return value.part(start, size), size, lone, True
            pieces.append((at, escape.next - at, escape.text))
            run = at = escape.next
        elif quotes and (char == quote if quote else char in "'\""):
            _end_run(pieces, text, run, at)
            quote, quoted_from = ("", 0) if quote else (char, at)
            at += 1
            run = at
        elif not quote and char in separators:
            break
        else:
            ordinary = _ORDINARY.match(text, at) if separators == BLANKS else None
            at = ordinary.end() if ordinary else at + 1
    if quote:
        bad = ValueProblem("unbalanced-quotes", value.part(quoted_from, size))
        return value.part(start, size), size, (bad,), True
    _end_run(pieces, text, run, at)
    word = _located(value, pieces, start, at) if pieces else Located("", value.part(start, at).span)
    return word, at, tuple(problems), False


def _end_run(pieces: list[tuple[int, int, str]], text: str, run: int, at: int) -> None:
    """Keep the characters since the last quote or escape."""
    if at > run:
        pieces.append((run, at - run, text[run:at]))


class Words(NamedTuple):
    words: tuple[Located, ...]
    problems: tuple[ValueProblem, ...]
    broken: bool
    """The last word could not be read; what is before it counts."""


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
    """A value that is in no file, for callers that only have a string."""
    source = Source("", text)
    return Located(text, Span(source, 0, len(text)))
