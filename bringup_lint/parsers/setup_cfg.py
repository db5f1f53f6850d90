"""The lines of a setup.cfg (configparser of Python): sections, and the options in them that start a line."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_LINE = regex(r"^\[([^\]\n]+)\]|^([A-Za-z][\w.-]*)[ \t]*[=:][ \t]*([^\n]*)", re.M)


class Setting(NamedTuple):
    """An option, or a section where there is none."""

    section: Located
    option: Located | None
    value: Located | None


def settings(source: Source) -> Iterator[Setting]:
    """Each section, and each of its options."""
    section: Located | None = None
    for match in _LINE.finditer(source.text):
        if match[1] is not None:
            section = Located(match[1], source.span(*match.span(1)))
            yield Setting(section, None, None)
        elif section is not None:
            value = Located(match[3], source.span(*match.span(3))).strip_located()
            yield Setting(section, Located(match[2], source.span(*match.span(2))), value)
