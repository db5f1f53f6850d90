"""Programs that everybody knows, their verbs, and which of them a misspelt name means."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

from bringup_lint import facts
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import Neighbours
from bringup_lint.spelling import is_slip


class Verbs(NamedTuple):
    """The words of which a program takes one."""

    slips: Neighbours
    valued: frozenset[str]
    """Its options that take the next word as their value."""
    abbreviates: bool
    """It understands the start of a verb."""


def meant_programs(name: str) -> list[str]:
    """The well-known programs of which one is misspelt here; none for the names of others that there are."""
    slips, others, spoken = _programs()
    if name in spoken:
        return [spoken[name]]
    found = [] if name in others else slips.meant(name)
    return [each for each in found if is_slip(name, each) and (len(each) > 3 or _is_doubled(name))]


def is_program(name: str) -> bool:
    """Whether it is the name of a program that is known, be it as the neighbour of another."""
    slips, others, _ = _programs()
    return name in slips.known or name in others


def _is_doubled(name: str) -> bool:
    """Whether a letter stands there twice: what else is near to three letters may be anything."""
    return any(one == other for one, other in pairwise(name))


@cache
def _programs() -> tuple[Neighbours, frozenset[str], dict[str, str]]:
    """Those that are known, their neighbours, and what other misspelt names mean."""
    rows = facts.table("host/programs")
    others = frozenset(near for row in rows for near in row["near"].split())
    spoken = {slip: row["name"] for row in rows for slip in row["slips"].split()}
    return Neighbours(row["name"] for row in rows), others, spoken


@cache
def verbs() -> dict[str, Verbs]:
    """The programs, and those of their verbs that take verbs of their own: ``git submodule``."""
    return {
        program: Verbs(Neighbours(row["verbs"].split()), frozenset(row["valued"].split()), row["abbreviates"] == "yes")
        for row in facts.table("host/verbs")
        for program in row["programs"].split(", ")
    }
