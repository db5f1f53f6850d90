"""Which known word a misspelt one means."""

from __future__ import annotations

from collections.abc import Collection
from collections.abc import Iterable

from bringup_lint.pattern import regex
from bringup_lint.type_names import TypeVar

Word = TypeVar("Word", bound=str)
_MANY = 300
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


def nearest_of_few(word: str, known: Collection[Word], farthest: int = 2) -> list[Word]:
    """The same, in the order of the words; none where so many are known that each of many questions would take
    long."""
    return nearest(word, sorted(known), farthest) if len(known) <= _MANY else []


def longer(name: str, known: Iterable[str]) -> list[str]:
    """The known names that end with a name, and say more before it: ``map_frame`` of ``frame``."""
    return [each for each in known if each.endswith(f"_{name}")]


class WordSlips:
    """Names of several words, of which each misspelt one is found in a time that does not depend on how many there
    are."""

    def __init__(self, known: Iterable[str]) -> None:
        self._near = Neighbours(known)

    def meant(self, name: str) -> str | None:
        """The one known name that differs in one of its words, by a letter more or less or by two neighbours that
        changed places. A plural, a past tense, another first letter or another number is another name."""
        return None if name in self._near.known else self.among_own(name)

    def among_own(self, name: str) -> str | None:
        """The same for a name that is itself among those that are known."""
        found = [each for each in self._near.near(name, _SHORTEST) if _is_slip(name, each)]
        return found[0] if len(found) == 1 else None


def slip_of(name: str, known: Iterable[str]) -> str | None:
    """The one of a few known names that is meant, as :class:`WordSlips` says."""
    return WordSlips(known).meant(name)


def _is_slip(name: str, other: str) -> bool:
    one, two = _SEPARATOR.split(name), _SEPARATOR.split(other)
    differing = [(a, b) for a, b in zip(one, two, strict=False) if a != b]
    if len(one) != len(two) or len(differing) != 1 or (len(name) == len(other) and sorted(name) != sorted(other)):
        return False
    a, b = differing[0]
    if max(len(a), len(b)) < _SHORTEST or a[:1] != b[:1] or a.rstrip("sd") == b.rstrip("sd"):
        return False
    return [each for each in a if each.isdigit()] == [each for each in b if each.isdigit()]


_SEPARATOR = regex(r"[_./-]")
_SHORTEST = 3
"""Letters of a word that is surely misspelt when one is missing."""


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


class Neighbours:
    """Words that are known, with all that is one letter away from them: one too many, one too few, another one, or two
    neighbours exchanged. To look a word up takes as long as the word is, however many are known."""

    def __init__(self, known: Iterable[str]) -> None:
        self.known = frozenset(each for each in known if len(each) <= _LONGEST)
        self._shorter: dict[str, list[str]] = {}
        """A known word without one letter -> the word."""
        for word in sorted(self.known):
            for short in _without_a_letter(word):
                self._shorter.setdefault(short, []).append(word)

    def meant(self, word: str) -> list[str]:
        """The known words of three letters or more for which this unknown one of four or more may stand."""
        return [] if word in self.known else self.near(word)

    def near(self, word: str, shortest: int = 4) -> list[str]:
        """The same for one that may be known itself, without that one."""
        if not shortest <= len(word) <= _LONGEST:
            return []
        shorter = _without_a_letter(word)
        near = {each for each in shorter if each in self.known}
        near.update(each for short in (word, *shorter) for each in self._shorter.get(short, ()))
        return sorted(each for each in near if len(each) > 2 and edits(word, each, 1) == 1)


def _without_a_letter(word: str) -> set[str]:
    """What is left without each letter in turn. Digits stay: names with other numbers are other names, and many."""
    return {word[:at] + word[at + 1 :] for at, letter in enumerate(word) if not letter.isdigit()}


def is_slip(word: str, meant: str) -> bool:
    """Whether a word that is one letter away from another may be a slip of the hand: two letters exchanged, one left
    out, one twice, or the one beside it on the keyboard. What else differs in a letter is rather another name."""
    one, other = _different(word, meant)
    if len(one) == len(other):
        return len(one) == 2 or other in _BESIDE.get(one, "")
    if not one:
        return True
    at = next((at for at, (has, wants) in enumerate(zip(word, meant)) if has != wants), len(meant))
    return one in word[max(at - 1, 0) : at] + meant[at : at + 1]


_ROWS = ("1234567890-", "qwertyuiop", "asdfghjkl", "zxcvbnm")
_BESIDE = {key: row[max(at - 1, 0) : at] + row[at + 1 : at + 2] for row in _ROWS for at, key in enumerate(row)}
