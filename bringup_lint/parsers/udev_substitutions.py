"""The ``$name`` and ``%letter`` substitutions in udev values."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from bringup_lint import facts
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem

_MARK = regex(r"[$%]")
_NUMBER = regex(r"[0-9]+\+?\Z")


class Substitution(NamedTuple):
    name: str
    letter: str
    argument: str
    """What the braces must hold: ``required``, ``number`` or empty."""


@cache
def _known() -> tuple[Substitution, ...]:
    return tuple(
        Substitution(row["name"], row["letter"], row["note"])
        for row in facts.table("udev/words")
        if row["kind"] == "substitution"
    )


def substitution_problems(value: Located) -> Iterator[Problem]:
    """What udev's check of a value complains about; it stops at the first complaint, as udev does."""
    at = 0
    while True:
        mark = _MARK.search(value, at)
        if mark is None:
            return
        start = mark.start()
        if value.startswith(mark[0], start + 1):
            at = start + 2
            continue
        known, after = _find(value, start)
        if known is None:
            yield Problem("bad-substitution", value.part(start, _word_end(value, start)), "unknown")
            return
        argument, at = _argument(value, after)
        if at == -1:
            yield Problem("bad-substitution", value.part(start, len(value)), "not closed")
            return
        if known.argument == "required" and not argument:
            yield Problem("substitution-without-argument", value.part(start, at))
            return
        if known.argument == "number" and argument is not None and not _NUMBER.match(argument):
            yield Problem("bad-substitution", value.part(start, at), "not a number")
            return


def _find(value: str, start: int) -> tuple[Substitution | None, int]:
    for known in _known():
        if value[start] == "$" and value.startswith(known.name, start + 1):
            return known, start + 1 + len(known.name)
        if value[start] == "%" and value.startswith(known.letter, start + 1):
            return known, start + 2
    return None, start + 1


def _argument(value: str, at: int) -> tuple[str | None, int]:
    if not value.startswith("{", at):
        return None, at
    close = value.find("}", at)
    return (None, -1) if close == -1 else (value[at + 1 : close], close + 1)


def _word_end(value: str, start: int) -> int:
    end = start + 1
    while end < len(value) and (value[end].isalnum() or value[end] == "_"):
        end += 1
        if value[start] == "%":
            break
    return end
