"""Makes broken and harmless variants of a configuration made of lines, and compares a parser with the real tool."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
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


def another_word(words: Sequence[str], indent: str = "") -> Callable[[str, random.Random], str]:
    """A change that gives another value to the directive of the line."""
    return lambda line, chance: f"{indent}{line.split()[0]} {chance.choice(words)}" if line.split() else line


def another_directive(names: Sequence[str], indent: str = "") -> Callable[[str, random.Random], str]:
    """A change that gives another directive to the value of the line."""
    return lambda line, chance: indent + " ".join([chance.choice(names), *line.split()[1:]]) if line.split() else line


def mutants(
    name: str, text: str, acts: Sequence[Act], count: int, at_once: Sequence[int], first: int = 0
) -> Iterator[str]:
    """So many different variants, the same in every run.

    ``at_once`` says how many acts may fall on one of them; lines before ``first`` are left alone.
    """
    chance = random.Random(name)
    seen: set[str] = set()
    while len(seen) < count:
        lines = text.splitlines()
        for _ in range(chance.choice(at_once)):
            lines = chance.choice(acts)(lines, chance.randrange(first, len(lines)), chance)
        variant = "\n".join(lines) + "\n"
        if variant not in seen:
            seen.add(variant)
            yield variant


def trials(
    seeds: Mapping[str, str], acts: Sequence[Act], count: int, at_once: Sequence[int], first: int = 0
) -> list[str]:
    """Every seed, and ``count`` variants of each."""
    return [text for name, seed in seeds.items() for text in (seed, *mutants(name, seed, acts, count, at_once, first))]


def judge(
    pairs: Iterable[tuple[str, tuple[list, str]]],
    ours: Callable[[str], list],
    differences: list[dict[str, str]],
) -> None:
    """Assert that the tool and the parser complain alike about each text, but for the reasoned differences.

    A tool's answer is its complaints, and all that it printed.
    """
    pairs = list(pairs)
    assert len(pairs) >= 400
    unexplained = [
        (theirs, ours(text), printed, text)
        for text, (theirs, printed) in pairs
        if theirs != ours(text) and not _is_meant(text, printed, differences)
    ]
    assert 0.3 < sum(bool(theirs) for _, (theirs, _) in pairs) / len(pairs) < 0.9
    for difference in unexplained:
        print("=" * 20, *difference, sep="\n")
    assert len(unexplained) <= len(pairs) // 100


def _is_meant(text: str, printed: str, differences: list[dict[str, str]]) -> bool:
    """Whether the table of differences has a row for it."""
    return any(
        ("says" in row and re.search(row["says"], printed, re.M))
        or ("text" in row and re.search(row["text"], text, re.M))
        for row in differences
    )
