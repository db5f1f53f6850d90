"""Which files mention the name of another one."""

from __future__ import annotations

import os
import re
from bisect import bisect_left
from collections.abc import Collection
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.source import Source

_LONGEST = 255
"""The longest name of a file."""


class Mentions:
    """The texts of a tree, each searched once for all names with one suffix."""

    def __init__(self, sources: Sequence[Source]) -> None:
        self._sources = sources
        self._by_suffix: dict[str, list[tuple[str, int]]] = {}

    def outside(self, name: str, known: Collection[Source]) -> bool:
        """Whether a text other than those of some files holds a name."""
        suffix = os.path.splitext(name)[1]
        if not suffix or "/" in name or name.split() != [name]:
            whole = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
            others = (source.text for source in self._sources if source not in known)
            return any(name in text and whole.search(text) is not None for text in others)
        if suffix not in self._by_suffix:
            self._by_suffix[suffix] = sorted(set(self._ends(suffix)))
        ends, wanted = self._by_suffix[suffix], name[::-1]
        at = bisect_left(ends, (wanted,))
        while at < len(ends) and ends[at][0].startswith(wanted):
            if self._sources[ends[at][1]] not in known:
                return True
            at += 1
        return False

    def _ends(self, suffix: str) -> Iterator[tuple[str, int]]:
        """What ends with a suffix, from its last character to the first, with the number of its text."""
        for number, source in enumerate(self._sources):
            text = source.text
            at = text.find(suffix)
            while at != -1:
                end = at + len(suffix)
                word = text[max(0, end - _LONGEST) : end].rpartition("/")[2].split()[-1]
                yield word[::-1], number
                at = text.find(suffix, end)
