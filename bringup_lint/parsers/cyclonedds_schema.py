"""The names that a version of Cyclone DDS knows (``find_cfgelem_by_name`` in ddsi_config.c).

Names ignore case. An alias counts like the name. Only XML given inline in ``CYCLONEDDS_URI`` may shorten a name to a
unique prefix.
"""

from __future__ import annotations

import re
from functools import cache
from functools import lru_cache

from bringup_lint.facts import table
from bringup_lint.model.cyclonedds import VERSIONS
from bringup_lint.model.schema import Item
from bringup_lint.schema.names import Spelling
from bringup_lint.schema.table import Schema
from bringup_lint.schema.table import load

IN_FILES = Spelling(folds=True, tells_prefixes=True)
INLINE = Spelling(folds=True, tells_prefixes=True, shortens=True)


@lru_cache
def schema(version: str) -> Schema:
    return load("dds/cyclonedds", version)


@lru_cache
def versions_with(path: str) -> tuple[str, ...]:
    """The versions that accept a path."""
    row = next((row for row in table("dds/cyclonedds") if row["path"] == path), None)
    return tuple(version for version in VERSIONS if row[version] != "no") if row else ()


def bare_unit(item: Item) -> str:
    """How a number without unit is read: ``B``, ``ms``, ``us``, or ``error``."""
    return item.row["bare"]


def repeats(item: Item) -> bool:
    """Whether an element may be there several times."""
    return item.row.get("max") == "unbounded"


def features_of(item: Item, version: str) -> frozenset[str]:
    """Compile-time features without which the item does not exist: ``tcp(11)`` is one in version 11 only."""
    return _features(item.row.get("build", ""), version)


@cache
def _features(build: str, version: str) -> frozenset[str]:
    found = re.findall(r"(\w+)(?:\(([^)]*)\))?", build)
    return frozenset(name for name, versions in found if not versions or version in versions.split(","))
