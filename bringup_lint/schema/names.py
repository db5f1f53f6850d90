"""Which item a written name means: exactly, in another case, by an alias, or shortened."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from bringup_lint.model.schema import Item
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import nearest


class How(Enum):
    EXACT = "exact"
    ALIAS = "alias"
    PREFIX = "prefix"
    AMBIGUOUS = "ambiguous"
    UNKNOWN = "unknown"


class Match(NamedTuple):
    item: Item | None
    how: How


class Spelling(NamedTuple):
    """How a program compares names."""

    folds: bool = False
    """Case does not count."""
    tells_prefixes: bool = False
    """A prefix of a single name is told from other unknown names."""
    shortens: bool = False
    """Such a prefix counts as the name."""
    drops_prefix: bool = False
    """A namespace prefix does not count."""


EXACT = Spelling()
FOLDED = Spelling(folds=True)


def find(items: Mapping[str, Item], name: str, spelling: Spelling = EXACT) -> Match:
    """The item among siblings that a written name means."""
    item = items.get(name)
    if item is not None:
        return Match(item, How.EXACT)
    if spelling.drops_prefix and ":" in name:
        return find(items, name.rpartition(":")[2])
    wanted = name.lower() if spelling.folds else name
    for item in items.values():
        if spelling.folds and item.name.lower() == wanted:
            return Match(item, How.EXACT)
        if any((alias.lower() if spelling.folds else alias) == wanted for alias in item.aliases):
            return Match(item, How.ALIAS)
    prefixed = [item for item in items.values() if _begins(item, wanted)] if spelling.tells_prefixes else []
    if len(prefixed) == 1:
        return Match(prefixed[0], How.PREFIX)
    return Match(None, How.AMBIGUOUS if prefixed and spelling.shortens else How.UNKNOWN)


def _begins(item: Item, wanted: str) -> bool:
    """Whether a name is the beginning of an item's. In Cyclone DDS, the name of an item with aliases may also be the
    beginning of what is written."""
    if item.deprecated:
        return False
    name = item.name.lower()
    return name.startswith(wanted) or (bool(item.aliases) and wanted.startswith(name))


def suggestions(items: Mapping[str, Item], name: str) -> list[str]:
    """The names that a misspelt one may mean: the same in another case, else the nearest ones."""
    known = [each for item in items.values() for each in (item.name, *item.aliases)]
    return [each for each in known if each.lower() == name.lower()] or nearest(name, known)
