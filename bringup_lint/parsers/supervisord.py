"""supervisord.conf, as supervisor's options.py reads it: Python's configparser with ``;`` comments after a blank."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.model.supervisord import Program
from bringup_lint.source import Located
from bringup_lint.source import Source

_HEADER = re.compile(r"[ \t]*\[program:(?P<name>[^\]\r\n]*)\]")
_OTHER_HEADER = re.compile(r"[ \t]*\[[^\]\r\n]*\]")
_SETTING = re.compile(r"(?P<key>[^\s=:;#\[][^=:\r\n]*?)[ \t]*[=:][ \t]*(?P<value>[^\r\n]*)")
_CONTINUED = re.compile(r"(?:\r?\n[ \t]+[^\r\n]*)*")
_COMMENT = re.compile(r"\s;")


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
    """A value with its continuation lines; a comment ends it."""
    end = source.text.find("\n", start)
    end = len(source.text) if end < 0 else end
    continued = _CONTINUED.match(source.text, end)
    end = continued.end() if continued else end
    comment = _COMMENT.search(source.text, max(start - 1, 0), end)
    return source.located(start, comment.start() if comment and comment.start() >= start else end).strip_located()
