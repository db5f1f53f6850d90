"""limits.conf and limits.d: who may have how much, limits.conf(5)."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Source


class Grant(NamedTuple):
    """One line."""

    domain: Located
    """A user, ``@group``, ``*``, or a range of ids."""
    type: str
    """``hard``, ``soft`` or ``-`` for both."""
    item: str
    value: Located
    line: Located


def parse(source: Source) -> list[Grant]:
    """The lines with four words; comments run to the end of their line. Never raises."""
    found = []
    start = 0
    for text in source.text.splitlines(keepends=True):
        line = source.located(start, start + len(text.partition("#")[0])).strip_located()
        start += len(text)
        words = list(line.words())
        if len(words) == 4:
            found.append(Grant(words[0], str(words[1]), str(words[2]).lower(), words[3], line))
    return found
