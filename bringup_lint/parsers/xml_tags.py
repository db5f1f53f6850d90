"""Start and end tags of XML, with their places; a broken attribute costs that attribute."""

from __future__ import annotations

import re

from bringup_lint.model.xml import Attribute
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml_text import Report
from bringup_lint.parsers.xml_text import decode
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

MAX_ATTRIBUTES = 256

_START = (
    ":A-Z_a-z\xc0-\xd6\xd8-\xf6\xf8-\u02ff\u0370-\u037d\u037f-\u1fff\u200c-\u200d\u2070-\u218f"
    "\u2c00-\u2fef\u3001-\ud7ff\uf900-\ufdcf\ufdf0-\ufffd\U00010000-\U000effff"
)
_NAME = regex(f"[{_START}][{_START}\\-.0-9\xb7\u0300-\u036f\u203f-\u2040]*")
_ASCII_NAME = regex(r"[:A-Z_a-z][:A-Z_a-z\-.0-9]*")
_BLANKS = regex(r"[ \t\r\n]*")
_EQUALS = regex(r"[ \t\r\n]*=[ \t\r\n]*")
_QUOTED = regex(r"\"[^\"<]*\"|'[^'<]*'")
_BARE = regex(r"[^ \t\r\n<>\"'/=]+")
_JUNK = regex(r"(?:[^ \t\r\n<>/]|/(?!>))+")
_OPEN_VALUE = regex(r"[\"'][^<>\r\n]*")


def name_at(text: str, start: int) -> re.Match[str] | None:
    """The name at a place. The pattern of all names is compiled where a text holds letters that need it: that takes as
    long as to read a hundred files."""
    return (_ASCII_NAME if text.isascii() else _NAME).match(text, start)


class StartTag(NamedTuple):
    name: Located
    attributes: tuple[Attribute, ...]
    closed: bool
    """True for ``<a/>``."""
    end: int
    """Offset behind ``>``, or where the tag was given up."""


def start_tag(source: Source, start: int, report: Report) -> StartTag | None:
    """Read the start tag whose ``<`` is at ``start``; None when no name follows."""
    text = source.text
    name = name_at(text, start + 1)
    if name is None:
        return None
    attributes: dict[str, Attribute] = {}
    at = name.end()
    closed = False
    while True:
        blank = _BLANKS.match(text, at).end()  # type: ignore[union-attr]
        if text.startswith(">", blank):
            at = blank + 1
            break
        if text.startswith("/>", blank):
            at, closed = blank + 2, True
            break
        if blank == len(text) or text[blank] == "<":
            report("unclosed-tag", start, blank, "'>' is missing")
            at = blank
            break
        if blank == at:
            report("missing-blank", at, at + 1, "a space is missing before it")
        at, attribute = _attribute(source, blank, report)
        if attribute is None:
            continue
        if attribute.name in attributes:
            span = attribute.name.span
            report("duplicate-attribute", span.start, span.end, attribute.name)
        elif len(attributes) == MAX_ATTRIBUTES:
            report("too-large", blank, at, f"more than {MAX_ATTRIBUTES} attributes")
        attributes.setdefault(attribute.name, attribute)
    return StartTag(source.located(*name.span()), tuple(attributes.values()), closed, at)


def _attribute(source: Source, start: int, report: Report) -> tuple[int, Attribute | None]:
    """Read ``name="value"``; returns where it ends, always behind ``start``."""
    text = source.text
    match = name_at(text, start)
    if match is None:
        junk = _JUNK.match(text, start)
        end = junk.end() if junk else start + 1
        report("bad-attribute", start, end, "not an attribute name")
        return end, None
    name = source.located(*match.span())
    equals = _EQUALS.match(text, match.end())
    if equals is None:
        report("bad-attribute", start, match.end(), "no value")
        return match.end(), None
    at = equals.end()
    quoted = _QUOTED.match(text, at)
    if quoted:
        return quoted.end(), Attribute(name, decode(source, at + 1, quoted.end() - 1, report))
    open_value = _OPEN_VALUE.match(text, at)
    if open_value is None:
        bare = _BARE.match(text, at)
        end = bare.end() if bare else at
        report("bad-attribute", start, end, "the value needs quotes")
        return end, Attribute(name, decode(source, at, end, report))
    end = open_value.end()
    if text.startswith("<", end):
        closing = _closing_quote(text, at, end)
        if closing:
            report("less-than-in-value", end, end + 1, "< must be written &lt;")
            return closing, Attribute(name, decode(source, at + 1, closing - 1, report))
    report("bad-attribute", at, end, "the closing quote is missing")
    return end, Attribute(name, decode(source, at + 1, end, report))


def _closing_quote(text: str, start: int, end: int) -> int:
    """Offset behind the quote that closes a value with ``<`` in it, on the same line; 0 without one."""
    line_end = text.find("\n", end, end + 4096)
    limit = line_end if line_end != -1 else min(end + 4096, len(text))
    return text.find(text[start], end, limit) + 1
