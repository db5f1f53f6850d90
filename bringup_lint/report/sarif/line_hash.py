"""The hash of a line by which GitHub's code scanning recognises a result after lines have moved.

It is what ``upload-sarif`` computes from the checkout for results that bring none (``src/fingerprints.ts`` of
github/codeql-action): a rolling hash of the 100 characters from the start of the line, blanks and tabs left out, and
how often it has come up so far.
"""

from __future__ import annotations

from array import array
from collections import Counter
from collections.abc import Iterator
from functools import lru_cache

from bringup_lint.source import Source

SIZE_LIMIT = 512 * 1024
"""Characters; in a longer file ``upload-sarif`` does it, in less time."""
_BLOCK = 100
_FACTOR = 37
_WORD = (1 << 64) - 1
_OLDEST = pow(_FACTOR, _BLOCK, 1 << 64)
_END = 65535
_LINE_FEED = 10


def line_hash(source: Source, line: int) -> str | None:
    """``1f2e3d:1`` for a line counted from 1; None where the text is not to the letter what the file holds."""
    text = source.text
    if source.virtual or source.masked or not text or len(text) > SIZE_LIMIT or "\ufffd" in text:
        return None
    return _hashes(text).get(line)


@lru_cache(maxsize=4)
def _hashes(text: str) -> dict[int, str]:
    seen: Counter[int] = Counter()
    found = {}
    for line, number in enumerate(_blocks(text), 1):
        seen[number] += 1
        found[line] = f"{number:x}:{seen[number]}"
    return found


def _blocks(text: str) -> Iterator[int]:
    """The hash of the block that begins with each line."""
    plain = text.replace("\r\n", "\n").replace("\r", "\n").replace(" ", "").replace("\t", "")
    units = array("H", plain.encode("utf-16-le", "surrogatepass"))
    units.append(_END)
    starts = [0, *(at + 1 for at, unit in enumerate(units[:-1]) if unit == _LINE_FEED)]
    units.extend([0] * _BLOCK)
    value = at = 0
    for start in starts:
        while at < start + _BLOCK:
            oldest = units[at - _BLOCK] if at >= _BLOCK else 0
            value = (value * _FACTOR + units[at] - _OLDEST * oldest) & _WORD
            at += 1
        yield value
