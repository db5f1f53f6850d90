"""Netplan's grammar: which key may stand in which mapping."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from bringup_lint import facts

DEVICE_TYPES = (
    "ethernets",
    "wifis",
    "vlans",
    "bridges",
    "bonds",
    "tunnels",
    "modems",
    "dummy-devices",
    "nm-devices",
    "virtual-ethernets",
    "vrfs",
)
_GROUP = {"devices": [kind for kind in DEVICE_TYPES if kind != "vrfs"]}


class Key(NamedTuple):
    """A key, the grammar of its value, and the release that brought it (empty: 0.104 has it)."""

    name: str
    value: str
    since: str


@cache
def tables() -> dict[str, dict[str, Key]]:
    """The keys of every mapping, by the name of its table: ``network``, ``ethernets``, ``route``, ..."""
    found: dict[str, dict[str, Key]] = {}
    for row in facts.table("network/netplan"):
        for name in row["tables"].split(","):
            for table in _GROUP.get(name, [name]):
                found.setdefault(table, {})[row["key"]] = Key(row["key"], row["value"], row["since"])
    return found


def home_of(key: str) -> str | None:
    """The one mapping, other than a device's own, that takes this key; None when none or several do."""
    homes = [table for table, keys in tables().items() if key in keys]
    if "ethernets" in homes:
        return "the interface itself"
    return homes[0] if len(homes) == 1 else None
