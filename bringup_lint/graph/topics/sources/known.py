"""The topics of common nodes of which the source is seldom in the tree, from the facts table."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple

VELOCITY = "velocity"
"""The type of topics that are ``Twist`` or ``TwistStamped``."""
ROLES = {"pub": "publisher", "sub": "subscription"}


class KnownTopic(NamedTuple):
    role: str
    """``publisher`` or ``subscription``."""
    name: str
    """The default; empty when only a parameter gives it."""
    parameter: str
    type: str | None
    """``VELOCITY`` where a parameter and the distribution decide."""
    reliability: str | None
    durability: str | None
    depth: int | None


class KnownNode(NamedTuple):
    topics: tuple[KnownTopic, ...]
    complete: bool
    """It has no other topics."""
    name: str | None
    """What the node calls itself."""


@cache
def _rows() -> dict[tuple[str, str], list[dict[str, str]]]:
    rows: dict[tuple[str, str], list[dict[str, str]]] = {}
    for row in table("ros/node_topics"):
        for program in (row["executable"], row["plugin"]):
            if program:
                rows.setdefault((row["package"], program), []).append(row)
    return rows


@cache
def known_node(package: str, program: str) -> KnownNode | None:
    """``program``: an executable or a component class."""
    rows = _rows().get((package, program))
    if rows is None:
        return None
    topics = tuple(_topic(row) for row in rows if row["role"] in ROLES)
    name = next((row["name"] for row in rows if row["role"] == "node"), None)
    return KnownNode(topics, not any(row["role"] == "more" for row in rows), name)


def _topic(row: dict[str, str]) -> KnownTopic:
    reliability, durability, depth = (*row["qos"].split(), None, None, None)[:3]
    type_ = row["type"] or None
    number = int(depth) if depth else None
    return KnownTopic(ROLES[row["role"]], row["name"], row["parameter"], type_, reliability, durability, number)
