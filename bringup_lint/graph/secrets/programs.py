"""Secrets in the sources of nodes and in scripts: names that say so, set to a literal that looks like one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.modules import TEST
from bringup_lint.graph.modules import modules
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_LITERAL = r"""(?P<quote>["'])(?P<value>[^\s"'\\]{8,200})(?P=quote)"""
_PATTERNS = {
    "python-node": (
        regex(r"(?<![\w\"'])(?P<name>[A-Za-z_]\w*)[ \t]*(?::[ \t]*str[ \t]*)?=[ \t]*" + _LITERAL),
        regex(r"""["'](?P<name>[A-Za-z_]\w*)["'][ \t]*[:,][ \t]*""" + _LITERAL),
    ),
    "shell-script": (
        regex(r"^[ \t]*(?:export[ \t]+)?(?P<name>[A-Za-z_]\w*)=" + _LITERAL, re.M),
        regex(r"^[ \t]*(?:export[ \t]+)?(?P<name>[A-Za-z_]\w*)=(?P<value>[^\s\"'$`;&|()<>\\]{8,200})[ \t]*$", re.M),
    ),
}
_LOOKS_DRAWN = regex(r"(?=.*[0-9])(?=.*[A-Za-z])[\w+/=.!@#^*:-]+$")


class Assigned(NamedTuple):
    """A name and the literal that a program gives it."""

    name: str
    value: Located


def assigned(files: Files) -> Iterator[Assigned]:
    """What the judged programs set to a literal with letters and digits: words of a language are not secrets."""
    for kind, patterns in _PATTERNS.items():
        for source in files.of_kind(kind):
            if source.judged and not TEST.search(source.name):
                yield from _in(source, patterns)
    for source in modules(files):
        yield from _in(source, _PATTERNS["python-node"])


def _in(source: Source, patterns: tuple[re.Pattern[str], ...]) -> Iterator[Assigned]:
    for match in (match for pattern in patterns for match in pattern.finditer(source.text)):
        if _LOOKS_DRAWN.match(match["value"]):
            yield Assigned(match["name"], source.located(*match.span("value")))
