"""Netplan's grammar: which key may be in which mapping."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from bringup_lint import facts
from bringup_lint.model.schema import Item
from bringup_lint.schema.table import Schema
from bringup_lint.schema.table import schema_of

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


@cache
def schema() -> Schema:
    """Each kind of mapping is a structure: ``{network}``, ``{ethernets}``, ``{route}``, ..."""
    return schema_of(_rows())


def _rows() -> Iterator[dict[str, str]]:
    for row in facts.table("network/netplan"):
        for name in row["tables"].split(","):
            for kind in _GROUP.get(name, [name]):
                yield {**row, "path": f"{{{kind}}}/{row['key']}"}


def mapping_of(kind: str) -> Item | None:
    """What may be in a mapping of a kind, such as ``network`` or ``route``; None for other words."""
    return schema().items.get(f"{{{kind}}}")


def home_of(key: str) -> str | None:
    """The one mapping, other than a device's own, that takes this key; None when none or several do."""
    homes = [kind for kind, item in schema().top.children.items() if key in item.children]
    if "{ethernets}" in homes:
        return "the interface itself"
    return homes[0].strip("{}") if len(homes) == 1 else None
