"""The tokens of shell text: words, quotes, operators and here-documents (POSIX.1-2017, chapter 2; bash(1)). Nothing is
expanded; what cannot be read is passed over."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.shell import HereDocument
from bringup_lint.model.shell import Word
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

ASSIGNMENT = regex(r"[A-Za-z_][A-Za-z0-9_]*\+?=")
_OPERATOR = regex(r"&&|\|\||;;&?|;&|\|&|&>>?|<<<|<<-?|<>|<&|>&|>>|>\||[;&|<>()\n]")
HERE = frozenset({"<<", "<<-"})
REDIRECTS = frozenset({"<", ">", ">>", "<&", ">&", "<>", ">|", "&>", "&>>", "<<<"})
_DELIMITER = regex(r"[ \t]*(?:'([^'\n]*)'|\"([^\"\n]*)\"|\\?([^ \t\r\n;&|<>()]*))")
_ESCAPE = regex(r"\\[$`\"\\\n]")
_PLAIN = regex(r"[^ \t\r\n\\'\"`$;&|<>()#]+")
_ALONE = regex(_PLAIN.pattern + r"(?=[ \t\r\n;&|<>()]|\Z)")
"""A word of which nothing is quoted or expanded."""
_MARK = regex(r"\\[\s\S]|\$[({]|[\"'`(){}]")
_SUBSTITUTED = regex(r"\$\((?!\()|`")
_INNER = {"$(": ")", "${": "}"}
"""What begins an expansion inside double quotes, and what ends it."""


class Token(NamedTuple):
    text: Located
    operator: bool
    document: HereDocument | None = None
    """The here-document that a ``<<`` operator starts."""


class _Open(NamedTuple):
    """A here-document whose text comes after the end of the line."""

    token: int
    delimiter: str
    quoted: bool
    tabs: bool


def tokens(script: Located) -> list[Token]:
    """The tokens of a script. Never raises."""
    text = str(script)
    at, size = 0, len(text)
    found: list[Token] = []
    opened: list[_Open] = []
    broken: list[int] = []
    while at < size:
        char = text[at]
        if char in " \t\r":
            at += 1
        elif text.startswith("\\\n", at):
            at += 2
        elif char == "#":
            at = _line_end(text, at)
        elif operator := _OPERATOR.match(text, at):
            found.append(Token(script.part(at, operator.end()), True))
            at = operator.end()
            if operator[0] in HERE:
                at, delimiter, quoted = _delimiter(text, at)
                opened.append(_Open(len(found) - 1, delimiter, quoted, operator[0] == "<<-"))
            elif char == "\n" and opened:
                at = _read_documents(script, at, opened, found)
                opened = []
        else:
            end, word = _word(script, at, broken)
            found.append(Token(word, False))
            at = end
    return found


def _word(script: Located, start: int, broken: list[int]) -> tuple[int, Word]:
    """The word at ``start``, its quotes removed, and where it ends."""
    text: str = script  # str(script) would copy the whole script for each word
    size = len(text)
    if alone := _ALONE.match(text, start):
        word = script.part(start, alone.end())
        return alone.end(), Word(word, word.span, ((0, script.origin(start)),), ("",))
    at = start
    out: list[str] = []
    pieces: list[tuple[int, int]] = []
    quotes: list[str] = []
    length = 0

    def keep(begin: int, end: int, quote: str = "") -> None:
        nonlocal length
        if end > begin:
            pieces.append((length, script.origin(begin)))
            out.append(text[begin:end])
            quotes.append(quote)
            length += end - begin

    while at < size:
        plain = _PLAIN.match(text, at)
        if plain:
            keep(at, plain.end())
            at = plain.end()
            continue
        char = text[at]
        if char == "\\":
            if not text.startswith("\n", at + 1):
                keep(at + 1, at + 2, "'")
            at += 2
        elif char == "'":
            end = _find(text, "'", at + 1)
            keep(at + 1, end, "'")
            at = end + 1
        elif char == '"':
            end = _closing_quote(text, at + 1, broken)
            for begin, stop, quote in _in_quotes(text, at + 1, end):
                keep(begin, stop, quote)
            at = end + 1
        elif char == "`":
            end = _find(text, "`", at + 1)
            keep(at, end + 1)
            at = end + 1
        elif char == "$" and text.startswith('"', at + 1):
            at += 1
        elif char == "$":
            end = _expansion_end(text, at)
            keep(at, end)
            at = end
        elif char == "#":
            keep(at, at + 1)
            at += 1
        else:
            break
    at = min(at, size)
    place = script.part(start, at)
    return at, Word("".join(out), place.span, tuple(pieces) or None, tuple(quotes))


def _expansion_end(text: str, at: int) -> int:
    """Where the expansion that starts with ``$`` ends, brackets balanced."""
    opening = text[at + 1 : at + 2]
    closing = {"(": ")", "{": "}"}.get(opening)
    if closing is None:
        return at + 1
    depth = 0
    for end in range(at + 1, len(text)):
        depth += (text[end] == opening) - (text[end] == closing)
        if depth == 0:
            return end + 1
    return len(text)


def _in_quotes(text: str, at: int, end: int) -> Iterator[tuple[int, int, str]]:
    """The stretches between double quotes: a backslash takes the meaning of what follows it, and a line end with it."""
    for escape in _ESCAPE.finditer(text, at, end):
        yield at, escape.start(), '"'
        at = escape.end()
        if text[at - 1] != "\n":
            yield at - 1, at, "'"
    yield at, end, '"'


def _closing_quote(text: str, at: int, broken: list[int]) -> int:
    """Where double quotes end: what ``$(...)`` and ``${...}`` between them quote has quotes of its own. A place from
    which that leads past the end of the text is noted in ``broken``, and none is looked at so closely after it."""
    end = -1 if broken else _closing_of_all(text, at)
    if end >= 0:
        return end
    broken.append(at)
    while at < len(text) and text[at] != '"':
        at += 2 if text[at] == "\\" else 1
    return min(at, len(text))


def _closing_of_all(text: str, at: int) -> int:
    """Where double quotes end, with all that is open inside of them; -1 where they do not."""
    inner = ['"']
    while match := _MARK.search(text, at):
        mark, at = match[0], match.end()
        if mark == inner[-1]:
            inner.pop()
            if not inner:
                return match.start()
        elif mark in _INNER:
            inner.append(_INNER[mark])
        elif mark == "(" and inner[-1] == ")":
            inner.append(")")
        elif mark == '"':
            inner.append('"')
        elif mark == "`" or (mark == "'" and inner[-1] == ")"):
            at = _find(text, mark, at) + 1
    return -1


def _find(text: str, what: str, at: int) -> int:
    found = text.find(what, at)
    return len(text) if found == -1 else found


def _line_end(text: str, at: int) -> int:
    return _find(text, "\n", at)


def _delimiter(text: str, at: int) -> tuple[int, str, bool]:
    """Where the delimiter ends, the delimiter, and whether a quote in it keeps the text from being expanded."""
    match = _DELIMITER.match(text, at)
    if match is None:
        return at, "", False
    delimiter = next((group for group in match.groups() if group is not None), "")
    return match.end(), delimiter, match[3] is None or match[0].lstrip().startswith("\\")


def _read_documents(script: Located, at: int, opened: list[_Open], found: list[Token]) -> int:
    text = str(script)
    for each in opened:
        start = stop = at
        while at < len(text):
            end = _line_end(text, at)
            line = text[at:end].rstrip("\r")
            stop, at = at, min(end + 1, len(text))
            if (line.lstrip("\t") if each.tabs else line) == each.delimiter:
                break
            stop = at
        document = HereDocument(script.part(start, stop), each.quoted, each.tabs)
        found[each.token] = found[each.token]._replace(document=document)
    return at


def substitutions(word: Located) -> Iterator[Located]:
    """The commands in the ``$(...)`` and backquotes of a word, but for those in single quotes."""
    if "$(" not in word and "`" not in word:
        return
    for stretch, quote in word.stretches() if isinstance(word, Word) else ((word, ""),):
        at = 0
        while quote != "'" and (match := _SUBSTITUTED.search(stretch, at)):
            closing = ")" if match[0] == "$(" else "`"
            at = _expansion_end(stretch, match.start()) if closing == ")" else _find(stretch, "`", match.end()) + 1
            if stretch[at - 1 : at] == closing and at > match.end():
                yield stretch.part(match.end(), at - 1)
