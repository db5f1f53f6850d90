"""Secrets in the sources of nodes and in scripts: names that say so, set to a literal that looks like one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_LITERAL = r"""(?P<quote>["'])(?P<value>[^\s"'\\]{8,200})(?P=quote)"""
_PATTERNS = {
    "python-node": (
        re.compile(r"(?<![\w\"'])(?P<name>[A-Za-z_]\w*)[ \t]*(?::[ \t]*str[ \t]*)?=[ \t]*" + _LITERAL),
        re.compile(r"""["'](?P<name>[A-Za-z_]\w*)["'][ \t]*[:,][ \t]*""" + _LITERAL),
    ),
    "shell-script": (
        re.compile(r"^[ \t]*(?:export[ \t]+)?(?P<name>[A-Za-z_]\w*)=" + _LITERAL, re.M),
        re.compile(
            r"^[ \t]*(?:export[ \t]+)?(?P<name>[A-Za-z_]\w*)=(?P<value>[^\s\"'$`;&|()<>\\]{8,200})[ \t]*$", re.M
        ),
    ),
}
_LOOKS_DRAWN = re.compile(r"(?=.*[0-9])(?=.*[A-Za-z])[\w+/=.!@#^*:-]+$")
_TEST = re.compile(r"(?:^|/)(?:tests?|examples?|samples?)/|(?:^|/)(?:test_[^/]*|[^/]*_test)\.")


class Assigned(NamedTuple):
    """A name and the literal that a program gives it."""

    name: str
    value: Located


def assigned(files: Files) -> Iterator[Assigned]:
    """What the judged programs set to a literal with letters and digits: words of a language are not secrets."""
    for kind, patterns in _PATTERNS.items():
        for source in files.of_kind(kind):
            if source.judged and not _TEST.search(source.name):
                for match in (match for pattern in patterns for match in pattern.finditer(source.text)):
                    if _LOOKS_DRAWN.match(match["value"]):
                        yield Assigned(match["name"], source.located(*match.span("value")))
