"""Secrets in the sources of nodes and in scripts: names that say so, set to a literal that looks like one."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.graph.modules import TEST
from bringup_lint.graph.modules import modules
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_LITERAL = r"""(?P<quote>["'])(?P<value>[^\s"'\\]{8,200})(?P=quote)"""
_GIVEN = regex(rf"=(?=[ \t]*{_LITERAL})")
_NAMED = regex(r"(?<![\w\"'])(?P<name>[A-Za-z_]\w*)[ \t]*(?::[ \t]*str[ \t]*)?\Z")
"""A literal that Python gives a name, and what is before it."""
_BEFORE = 200
"""Characters before a literal in which its name is looked for."""
_KEYED = regex(r"""["'](?P<name>[A-Za-z_]\w*)["'][ \t]*[:,][ \t]*""" + _LITERAL)
_OF_SHELL = (
    regex(r"^[ \t]*(?:export[ \t]+)?(?P<name>[A-Za-z_]\w*)=" + _LITERAL, re.M),
    regex(r"^[ \t]*(?:export[ \t]+)?(?P<name>[A-Za-z_]\w*)=(?P<value>[^\s\"'$`;&|()<>\\]{8,200})[ \t]*$", re.M),
)
_LOOKS_DRAWN = regex(r"(?=.*[0-9])(?=.*[A-Za-z])[\w+/=.!@#^*:-]+$")


class Assigned(NamedTuple):
    """A name and the literal that a program gives it."""

    name: str
    value: Located


def assigned(files: Files) -> Iterator[Assigned]:
    """What the judged programs set to a literal with letters and digits: words of a language are not secrets."""
    for kind, found in (("python-node", _in_python), ("launch-python", _in_python), ("shell-script", _in_shell)):
        for source in files.of_kind(kind):
            if source.judged and not TEST.search(source.name):
                yield from found(source)
    for source in modules(files):
        yield from _in_python(source)


def _in_python(source: Source) -> Iterator[Assigned]:
    text = source.text
    for match in _GIVEN.finditer(text):
        if _LOOKS_DRAWN.match(match["value"]):
            named = _NAMED.search(text, max(0, match.start() - _BEFORE), match.start())
            if named:
                yield _assigned(source, named["name"], match)
    yield from _of(source, _KEYED)


def _in_shell(source: Source) -> Iterator[Assigned]:
    for pattern in _OF_SHELL:
        yield from _of(source, pattern)


def _of(source: Source, pattern: re.Pattern[str]) -> Iterator[Assigned]:
    for match in pattern.finditer(source.text):
        if _LOOKS_DRAWN.match(match["value"]):
            yield _assigned(source, match["name"], match)


def _assigned(source: Source, name: str, match: re.Match[str]) -> Assigned:
    return Assigned(name, source.located(*match.span("value")))
