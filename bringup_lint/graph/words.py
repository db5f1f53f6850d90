"""The words of a text, and the names of files that they mean."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from fnmatch import fnmatchcase

from bringup_lint.pattern import regex

_WORD = regex(r"[\w*](?:[\w.*+-]*[\w*-])?")
_PREFIX = 4
"""Letters of the first part of a computed name, at least."""


def words(text: str) -> set[str]:
    return set(_WORD.findall(text))


def named(names: Iterable[str], words: set[str]) -> Iterator[str]:
    """The names of files that some words mean, as they are, by a wildcard, or by what is fixed of a computed name."""
    patterns = [word for word in words if "*" in word and len(word) >= _PREFIX]
    prefixes = tuple(word for word in words if word.endswith(("_", "-")) and len(word) >= _PREFIX)
    for name in names:
        if name in words or name.startswith(prefixes) or not words.isdisjoint(_ends(name)):
            yield name
        elif any(fnmatchcase(name, pattern) for pattern in patterns):
            yield name


def _ends(name: str) -> Iterator[str]:
    """The ends of a name that hold more than its suffix: what is written of one whose first part is computed."""
    for at, letter in enumerate(name[: name.rfind(".")]):
        if letter in "._-":
            yield name[at + 1 :]
            yield name[at:]
