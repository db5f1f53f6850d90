"""What a folder that is taken for one robot says against that."""

from __future__ import annotations

import os
from collections.abc import Iterator

from bringup_lint.fleet.fleet import listed
from bringup_lint.fleet.inventory import ARCHIVES
from bringup_lint.fleet.inventory import FILE_NAME
from bringup_lint.fleet.members import Member

INVENTORIES = ("inventory.yml", "inventory.yaml", "hosts.yml", "hosts.yaml")
"""What Ansible inventories are called."""
_TOP = "etc"
"""The folder that every robot has."""
_FEWEST = 2


def hint(member: Member) -> str:
    """What to name in place of the folder of a robot; empty where it is one, or nothing says that it is not."""
    folder = member.layers[0] if len(member.layers) == 1 else ""
    if not os.path.isdir(folder) or os.path.isdir(os.path.join(folder, _TOP)):
        return ""
    try:
        names = sorted(os.listdir(folder))
    except OSError:
        return ""
    for name in INVENTORIES:
        if name in names:
            return f"'{folder}' is taken for one robot: to judge the hosts of its inventory, name {_at(folder, name)}"
    robots = list(_robots(folder, names))
    if len(robots) < _FEWEST:
        return ""
    each = f"name each of them, such as {_at(folder, robots[0])}, or write a {FILE_NAME}"
    return f"'{folder}' is taken for one robot, but looks like a folder of {len(robots)} ({listed(robots)}): {each}"


def _robots(folder: str, names: list[str]) -> Iterator[str]:
    """The archives, and the folders with an ``etc`` of their own."""
    for name in names:
        place = _at(folder, name)
        if name.endswith(ARCHIVES) if os.path.isfile(place) else os.path.isdir(os.path.join(place, _TOP)):
            yield name


def _at(folder: str, name: str) -> str:
    return os.path.normpath(os.path.join(folder, name))
