"""Which known word a misspelt one means."""

from __future__ import annotations

from collections.abc import Iterable

from bringup_lint.type_names import TypeVar

Word = TypeVar("Word", bound=str)
_LONGEST = 255
"""Characters of a name; what differs in more is no name that somebody misspelt."""


def meant(name: str, known: Iterable[str]) -> str | None:
    """The known name that somebody meant: misspelt, or the last part of a path."""
    import difflib

    if len(name) > _LONGEST:
        return None
    known = [each for each in known if len(each) <= _LONGEST]
    ends = [each for each in known if each.endswith(f"/{name}")]
    near = ends if len(ends) == 1 else difflib.get_close_matches(name, known, 1, 0.8)
    return near[0] if near else None


def nearest(word: str, known: Iterable[Word], farthest: int = 2) -> list[Word]:
    """The known words with the fewest edits (a swap of neighbours is one), in the order given.

    Short words allow fewer edits: no more than a third of their length.
    """
    limit = min(farthest, len(word) // 3)
    if not limit:
        return []
    best: list[Word] = []
    for other in known:
        distance = edits(word.lower(), other.lower(), limit)
        if distance < limit:
            best, limit = [other], distance
        elif distance == limit:
            best.append(other)
    return best


def numbered(one: str, other: str) -> bool:
    """Whether two names differ in their digits only: ``camera_1`` and ``camera_2`` are two names, not one misspelt."""
    return one != other and without_digits(one) == without_digits(other)


def without_digits(name: str) -> str:
    return name.translate(_NO_DIGITS)


_NO_DIGITS = dict.fromkeys(map(ord, "0123456789"))


def edits(one: str, other: str, limit: int) -> int:
    """The edit distance with swaps of neighbours, or ``limit + 1`` when it is more."""
    if abs(len(one) - len(other)) > limit:
        return limit + 1
    one, other = _different(one, other)
    if max(len(one), len(other)) > _LONGEST:
        return limit + 1
    before: list[int] = []
    row = list(range(len(other) + 1))
    for i, char in enumerate(one, 1):
        before, last, row = row, before, [i]
        for j, wanted in enumerate(other, 1):
            cost = min(before[j] + 1, row[-1] + 1, before[j - 1] + (char != wanted))
            if last and i > 1 and j > 1 and char == other[j - 2] and one[i - 2] == wanted:
                cost = min(cost, last[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
    return row[-1]


def _different(one: str, other: str) -> tuple[str, str]:
    """Two words without what both begin and end with, which takes no edit."""
    start, shorter = 0, min(len(one), len(other))
    while start < shorter and one[start] == other[start]:
        start += 1
    end = 0
    while end < shorter - start and one[-1 - end] == other[-1 - end]:
        end += 1
    return one[start : len(one) - end], other[start : len(other) - end]
