"""Specifiers: ``%i``, ``%h`` and their kin in unit files, systemd.unit(5)."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Mapping
from functools import cache

from bringup_lint import facts
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values.problems import LINE
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.source import Located


class Specifier(NamedTuple):
    letter: str
    expands: str
    """``name``: safe in a file name; ``path``: an absolute path; ``text``: anything."""
    since: int
    in_unit_names: bool


@cache
def specifiers() -> dict[str, Specifier]:
    return {
        letter: Specifier(letter, expands, int(since), in_names == "yes")
        for letter, expands, since, in_names, _ in facts.rows("systemd/specifiers")[1]
    }


def occurrences(value: Located) -> Iterator[Located]:
    """Every ``%x`` that systemd looks up: those with a letter or digit; ``%%`` and the others stand for themselves."""
    at = value.find("%")
    while 0 <= at < len(value) - 1:
        letter = value[at + 1]
        if letter.isascii() and letter.isalnum():
            yield value.part(at, at + 2)
        at = value.find("%", at + 2 if letter == "%" or letter.isalnum() else at + 1)


def check_specifiers(
    value: Located, version: int, effect: str = LINE, *, unit_name: bool = False
) -> Iterator[ValueProblem]:
    """The specifiers that the release does not know here."""
    if "%" not in value:
        return
    for place in occurrences(value):
        known = specifiers().get(place[1])
        if known is None or (unit_name and not known.in_unit_names):
            yield ValueProblem("unknown-specifier", place, effect=effect, suggestion=f"%{place}")
        elif known.since > version:
            yield ValueProblem("specifier-too-new", place, effect=effect, since=known.since)


def literal(text: str) -> str | None:
    """The text when it holds no specifier, ``%%`` taken for ``%``; else None."""
    if "%" not in text:
        return text
    out = []
    at = 0
    while at < len(text):
        if text[at] == "%" and at + 1 < len(text):
            if text[at + 1] == "%":
                at += 1
            elif text[at + 1].isascii() and text[at + 1].isalnum():
                return None
        out.append(text[at])
        at += 1
    return "".join(out)


def expand(text: str, known: Mapping[str, str | None]) -> str | None:
    """The text with ``known`` (letter to value) put in; None when it lacks a specifier or has None for it."""
    if "%" not in text:
        return str(text)
    out = []
    at = 0
    while at < len(text):
        char = text[at]
        following = text[at + 1 : at + 2]
        if char == "%" and following == "%":
            out.append("%")
            at += 2
        elif char == "%" and following.isascii() and following.isalnum():
            found = known.get(following)
            if found is None:
                return None
            out.append(found)
            at += 2
        else:
            out.append(char)
            at += 1
    return "".join(out)


def unit_specifiers(unit: str) -> dict[str, str | None]:
    """What the specifiers that follow from the unit's name stand for: ``%n %N %p %P %i %I %j %J %f``.

    ``%i`` and ``%I`` of a unit that is no instance are empty; of a template they are unknown (None).
    """
    from bringup_lint.parsers.systemd_values.unit_names import split_name
    from bringup_lint.parsers.systemd_values.unit_names import unescape

    name = split_name(unit)
    last = name.prefix.rpartition("-")[2]
    instance = None if name.is_template else name.instance or ""
    values: dict[str, str | None] = {
        "n": None if name.is_template else unit,
        "N": None if name.is_template else unit.rpartition(".")[0],
        "p": name.prefix,
        "P": unescape(name.prefix),
        "i": instance,
        "I": None if instance is None else unescape(instance),
        "j": last,
        "J": unescape(last),
    }
    path = values["I"] if name.instance or name.is_template else values["P"]
    values["f"] = None if path is None else path if path.startswith("/") else "/" + path
    return values
