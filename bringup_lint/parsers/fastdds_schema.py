"""The elements that a version of Fast DDS knows."""

from __future__ import annotations

from functools import lru_cache

from bringup_lint.model.fastdds import VERSIONS
from bringup_lint.model.schema import Item
from bringup_lint.schema.table import Schema
from bringup_lint.schema.table import load


@lru_cache
def schema(version: str) -> Schema:
    return load("dds/fastdds", version)


@lru_cache
def versions_with(path: str) -> tuple[str, ...]:
    """The versions that take a path."""
    return tuple(version for version in VERSIONS if path in schema(version).items)


@lru_cache
def elsewhere(name: str, version: str) -> tuple[str, ...]:
    """The paths at which an element of this name may appear."""
    return tuple(path for path, item in schema(version).items.items() if item.name == name and not item.is_attribute)


def passes_over(item: Item) -> bool:
    """Whether unknown children are passed over, not refused."""
    return item.row.get("unknown") == "ignored"


def needs_content(item: Item) -> bool:
    return item.row.get("empty") == "error"


def read_by(item: Item) -> tuple[str, ...]:
    """The kinds of transport (udp, tcp, shm) that read the element; empty for all."""
    kinds = item.row.get("only", "")
    return tuple(kinds.split(",")) if kinds else ()
