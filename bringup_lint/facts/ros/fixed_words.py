"""Parameters and keys whose values a program compares with a fixed list of words."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import rows
from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple

PARAMS = "params"


class FixedWords(NamedTuple):
    where: tuple[str, ...]
    """``params``, or words of which the path of a file has one."""
    name: str
    beside: str
    """A parameter of the same section that says whose it is; empty when the name says so."""
    words: tuple[str, ...]
    ends: bool
    effect: str


@cache
def fixed_words() -> tuple[FixedWords, ...]:
    return tuple(
        FixedWords(
            tuple(row["where"].split()),
            row["name"],
            row["beside"],
            _words(row["words"]),
            bool(row["ends"]),
            row["effect"],
        )
        for row in table("ros/fixed_words")
    )


def _words(text: str) -> tuple[str, ...]:
    return tuple(name for name, *_ in rows(f"ros/{text[1:]}")[1]) if text.startswith("=") else tuple(text.split())
