"""What a rule needs to find anything, as alternatives of things that must be there."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

Path = tuple[Any, ...]
Atom = tuple[str, Any]
"""One thing that must be there: ``("some", path)`` a list of the robot that is not empty, ``("true", path)`` a value
of the robot that is true, ``("key", "KillMode")`` a unit that sets it, ``("type", "timer")`` and
``("manager", "user")`` a unit of this type and manager. A path is a tuple of names of attributes, and of tuples for
calls: the name and the arguments."""
Needs = frozenset[frozenset[Atom]]
"""Alternatives, one of which must be there as a whole."""

NOTHING: Needs = frozenset([frozenset()])
"""Needs that are always met."""
NEVER: Needs = frozenset()
"""Needs that nothing meets."""
_MOST_ALTERNATIVES = 24


def either(*each: Needs) -> Needs:
    """One of several needs."""
    together = frozenset().union(*each)
    return NOTHING if frozenset() in together else together


def both(one: Needs, other: Needs) -> Needs:
    """All of two needs; only one of them where the alternatives would be many."""
    if len(one) * len(other) > _MOST_ALTERNATIVES:
        return min(one, other, key=len)
    return either(frozenset(mine | theirs for mine in one for theirs in other))


def one(kind: str, what: Any) -> Needs:
    """The need of a single thing."""
    return frozenset([frozenset([(kind, what)])])


def any_of(kind: str, each: Iterable[Any]) -> Needs:
    """The need of one of several things."""
    return frozenset(frozenset([(kind, what)]) for what in each)
