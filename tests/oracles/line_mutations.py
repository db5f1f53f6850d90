"""Breeds broken and harmless variants of a configuration made of lines, and holds a parser against the real tool."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Sequence

Act = Callable[[list[str], int, random.Random], list[str]]
"""What may happen to the line at an index: the changed lines."""


def drop(lines: list[str], at: int, chance: random.Random) -> list[str]:
    return lines[:at] + lines[at + 1 :]


def twice(lines: list[str], at: int, chance: random.Random) -> list[str]:
    return lines[: at + 1] + lines[at:]


def swap(lines: list[str], at: int, chance: random.Random) -> list[str]:
    other = chance.randrange(len(lines))
    lines[at], lines[other] = lines[other], lines[at]
    return lines


def on_line(change: Callable[[str, random.Random], str]) -> Act:
    """An act that rewrites the line and leaves the others alone."""
    return lambda lines, at, chance: [*lines[:at], change(lines[at], chance), *lines[at + 1 :]]


def before_line(new: Callable[[random.Random], str]) -> Act:
    """An act that puts a new line above."""
    return lambda lines, at, chance: [*lines[:at], new(chance), *lines[at:]]


def cut(line: str, chance: random.Random) -> str:
    return line[: chance.randrange(len(line) + 1)]


def typo(letters: str) -> Callable[[str, random.Random], str]:
    def change(line: str, chance: random.Random) -> str:
        i = chance.randrange(len(line)) if line else 0
        return line[:i] + chance.choice(letters) + line[i + chance.randrange(2) :] if line else line

    return change


def mutants(name: str, text: str, acts: Sequence[Act], count: int, at_once: Sequence[int]) -> Iterator[str]:
    """So many different variants, the same in every run; ``at_once`` says how many acts may fall on one of them."""
    chance = random.Random(name)
    seen: set[str] = set()
    while len(seen) < count:
        lines = text.splitlines()
        for _ in range(chance.choice(at_once)):
            lines = chance.choice(acts)(lines, chance.randrange(len(lines)), chance)
        variant = "\n".join(lines) + "\n"
        if variant not in seen:
            seen.add(variant)
            yield variant


def hold_against(
    trials: Iterable[str],
    real: Callable[[str], tuple[list, str]],
    ours: Callable[[str], list],
    differences: list[dict[str, str]],
) -> None:
    """Assert that the tool and the parser complain alike about each text, but for the reasoned differences."""
    trials = list(trials)
    assert len(trials) >= 400
    complained = 0
    unexplained = []
    for text in trials:
        theirs, printed = real(text)
        complained += bool(theirs)
        if theirs != ours(text) and not _is_meant(text, printed, differences):
            unexplained.append((theirs, ours(text), printed, text))
    assert 0.3 < complained / len(trials) < 0.9
    for difference in unexplained:
        print("=" * 20, *difference, sep="\n")
    assert len(unexplained) <= len(trials) // 100


def _is_meant(text: str, printed: str, differences: list[dict[str, str]]) -> bool:
    """Whether the table of differences has a row for it."""
    return any(
        ("says" in row and re.search(row["says"], printed, re.M))
        or ("text" in row and re.search(row["text"], text, re.M))
        for row in differences
    )
