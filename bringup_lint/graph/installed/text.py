"""What a shell makes of words and here-documents, as far as the script itself says it (bash(1), "EXPANSION").

A value that is not known becomes a placeholder, ``{{ NAME }}``, so that whoever reads the text treats it as a template.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Mapping

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.shell import HereDocument
from bringup_lint.model.shell import Word
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Piece
from bringup_lint.source import Span

_EXPANSION = regex(
    r"\\(?P<escaped>[\s\S])|\$(?P<name>[A-Za-z_]\w*|[0-9@*#?$!-])|\$\{(?P<braced>[^{}]*)\}"
    r"|\$\((?P<command>(?:[^()]|\((?:[^()]|\([^()]*\))*\))*)\)|`(?P<ticks>[^`]*)`"
)
_NAME = regex(r"[A-Za-z_]\w*")
_ESCAPES = {"n": "\n", "t": "\t", "r": "\r", "\\": "\\", '"': '"', "a": "", "b": "", "e": ""}
_ESCAPE = regex(r"\\(.)")
_FORMAT = regex(r"%(?P<kind>[s%dib])")

_LONGEST = 4096
"""Characters of a value that is filled in: variables made of others twice would double without end."""

Values = Mapping[str, str | None]
"""The variables of a script; None where a value is not known."""


@dataclass
class Text:
    """A text that a script makes, which knows where it comes from."""

    parts: list[str] = field(default_factory=list)
    places: list[tuple[int, int]] = field(default_factory=list)

    def add(self, text: str, start: int, end: int) -> None:
        if text:
            self.parts.append(text)
            self.places.append((start, end))

    def extend(self, other: Text) -> None:
        self.parts += other.parts
        self.places += other.places

    def __str__(self) -> str:
        return "".join(self.parts)

    @property
    def pieces(self) -> tuple[Piece, ...]:
        found = []
        at = 0
        for part, place in zip(self.parts, self.places):
            found.append(Piece(at, *place))
            at += len(part)
        return tuple(found)

    @property
    def verbatim(self) -> bool:
        """Whether it is the same text as in the script."""
        return all(len(part) == end - start for part, (start, end) in zip(self.parts, self.places))


def document(found: HereDocument, values: Values) -> Text:
    """The text that a here-document gives to the command's standard input."""
    text = Text()
    for line in _lines(found.text):
        tabs = len(line) - len(line.lstrip("\t")) if found.tabs else 0
        line = line.part(tabs, len(line))
        if found.quoted:
            _keep(text, line)
        else:
            _expand(text, line, values, "$`\\\n")
    return text


def word_text(word: Located, values: Values) -> Text:
    """What a word becomes, without splitting it or replacing patterns by the names of files."""
    text = Text()
    if not isinstance(word, Word) or word.pieces is None:
        _expand(text, word, values, '$`"\\\n')
        return text
    for part, quote in word.stretches():
        if quote == "'":
            _keep(text, part)
        else:
            _expand(text, part, values, '$`"\\\n')
    return text


def as_it_is(part: Located) -> Text:
    """A text in which nothing is expanded."""
    text = Text()
    _keep(text, part)
    return text


def plain(word: Located, values: Values) -> str:
    return str(word_text(word, values))


def echoed(words: Iterable[Located], values: Values) -> Text:
    """What echo prints."""
    text = Text()
    escapes, newline = False, True
    rest = list(words)
    while rest and re.fullmatch(r"-[neE]+", rest[0]):
        escapes |= "e" in rest[0]
        newline &= "n" not in rest[0]
        rest.pop(0)
    for number, word in enumerate(rest):
        if number:
            text.add(" ", word.span.start, word.span.start)
        each = word_text(word, values)
        text.extend(_unescaped(each) if escapes else each)
    if newline:
        end = rest[-1].span.end if rest else 0
        text.add("\n", end, end)
    return text


def printed(words: tuple[Located, ...], values: Values) -> Text | None:
    """What printf prints; None for formats that are more than ``%s``."""
    if not words:
        return None
    arguments = list(words[1:])
    text = Text()
    layout = _unescaped(word_text(words[0], values))
    for part, (start, end) in zip(layout.parts, layout.places):
        at = 0
        for match in _FORMAT.finditer(part):
            _slice(text, part, at, match.start(), start, end)
            if match["kind"] == "%":
                text.add("%", start, end)
            elif arguments:
                text.extend(word_text(arguments.pop(0), values))
            at = match.end()
        _slice(text, part, at, len(part), start, end)
    return None if arguments or "%" in _FORMAT.sub("", str(layout)) else text


def _slice(text: Text, part: str, begin: int, stop: int, start: int, end: int) -> None:
    linear = len(part) == end - start
    text.add(part[begin:stop], start + begin if linear else start, start + stop if linear else end)


def _unescaped(text: Text) -> Text:
    """``\\n`` and the like as echo -e and printf read them."""
    found = Text()
    for part, (start, end) in zip(text.parts, text.places):
        at = 0
        for match in _ESCAPE.finditer(part):
            _slice(found, part, at, match.start(), start, end)
            linear = len(part) == end - start
            place = (start + match.start(), start + match.end()) if linear else (start, end)
            found.add(_ESCAPES.get(match[1], match[0]), *place)
            at = match.end()
        _slice(found, part, at, len(part), start, end)
    return found


def _lines(text: Located) -> Iterable[Located]:
    at = 0
    for line in str(text).splitlines(keepends=True):
        yield text.part(at, at + len(line))
        at += len(line)


def _keep(text: Text, part: Located) -> None:
    """Add a part as it is, in stretches that are together in the source too."""
    span: Span = part.span
    if len(part) == span.end - span.start:
        text.add(str(part), span.start, span.end)
        return
    for at, char in enumerate(part):
        text.add(char, part.origin(at), part.origin(at) + 1)


def _expand(text: Text, part: Located, values: Values, escapable: str) -> None:
    at = 0
    whole = str(part)
    if "$" not in whole and "\\" not in whole and "`" not in whole:
        _keep(text, part)
        return
    for match in _EXPANSION.finditer(whole):
        _keep(text, part.part(at, match.start()))
        at = match.end()
        place = (part.origin(match.start()), part.origin(match.end() - 1) + 1)
        if (char := match["escaped"]) is not None:
            text.add("" if char == "\n" else char if char in escapable else match[0], *place)
        else:
            text.add(_value(match, values), *place)
    _keep(text, part.part(at, len(part)))


def _value(match: re.Match[str], values: Values) -> str:
    name = match["name"] or match["braced"]
    if name is None:
        return "{{ command }}"
    known = values.get(name)
    if known is not None and len(known) <= _LONGEST:
        return known
    found = _NAME.match(name)
    return f"{{{{ {found[0] if found else 'argument'} }}}}"
