"""supervisord.conf, as supervisor's options.py reads it: Python's configparser with inline comments after a blank."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.model.supervisord import Program
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_HEADER = regex(r"[ \t]*\[program:(?P<name>[^\]\r\n]*)\]")
_OTHER_HEADER = regex(r"[ \t]*\[[^\]\r\n]*\]")
_SETTING = regex(r"(?P<key>[^\s=:;#\[][^=:\r\n]*?)[ \t]*[=:][ \t]*(?P<value>[^\r\n]*)")
_CONTINUED = regex(r"\n(?:[ \t]*[;#][^\n]*|[ \t\r]*(?=\n|\Z)|[ \t]+\S[^\n]*)")
"""A comment, an empty line, or an indented one: none of them ends a value."""
_COMMENT = regex(r"(?:(?<=\s)|^)[;#][^\n]*", re.M)


def parse(source: Source) -> list[Program]:
    """The programs of a file, in their order. Lines that configparser refuses cost themselves."""
    programs: list[Program] = []
    current: Program | None = None
    for start, end in _lines(source.text):
        header = _HEADER.match(source.text, start, end)
        setting = _SETTING.match(source.text, start, end)
        if header:
            current = Program(source.located(*header.span("name")), source.span(start, end))
            programs.append(current)
        elif _OTHER_HEADER.match(source.text, start, end):
            current = None
        elif setting and current is not None:
            current.settings[setting["key"].lower()] = _value(source, setting.start("value"))
    return programs


def _lines(text: str) -> Iterator[tuple[int, int]]:
    start = 0
    while start < len(text):
        end = text.find("\n", start)
        end = len(text) if end < 0 else end
        yield start, end
        start = end + 1


def _value(source: Source, start: int) -> Located:
    """A value with its continuation lines; comments in it become blanks, so that every place stays."""
    end = source.text.find("\n", start)
    end = len(source.text) if end < 0 else end
    while continued := _CONTINUED.match(source.text, end):
        end = continued.end()
    text = _COMMENT.sub(lambda comment: " " * len(comment[0]), source.text[start:end])
    return Located(text, source.span(start, end)).strip_located()
