"""The inventory: which robots there are, and where their files lie."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from bringup_lint.config import ConfigError
from bringup_lint.discover.tree import display_name
from bringup_lint.fleet.ansible import read_ansible
from bringup_lint.fleet.members import ROLE
from bringup_lint.fleet.members import Accepted
from bringup_lint.fleet.members import Inventory
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.members import refusal
from bringup_lint.fleet.members import text_of
from bringup_lint.pattern import regex
from bringup_lint.spelling import meant
from bringup_lint.toml import line_of
from bringup_lint.toml import read_toml

FILE_NAME = "fleet.toml"
ARCHIVES = (".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.bz2")
TALKS = ("shared", "separate")
_ACCEPT = regex(r"[ \t]*\[\[[ \t]*accept[ \t]*\]\]")
_KEYS: dict[str, dict[str, type]] = {
    "": {"robot": list, "site": dict, "accept": list},
    "robot": {"name": str, "role": str, "site": str, "root": str, "overlays": list, "domain": int},
    "site": {"domains": str},
    "accept": {"rule": str, "robots": list, "key": str, "reason": str},
}


def read_inventory(paths: Iterable[str]) -> Inventory:
    """The robots of folders, archives and inventories. Raises ConfigError."""
    members: list[Member] = []
    accepted: list[Accepted] = []
    for path in paths:
        found = _of_path(path)
        members += found.members
        accepted += found.accepted
    counts = Counter(member.name for member in members)
    for name, count in counts.items():
        if count > 1:
            raise ConfigError(f"two robots are called '{name}': name them in a {FILE_NAME}")
    if not members:
        raise ConfigError("there is no robot: give a folder or an archive for each, or an inventory")
    return Inventory(tuple(sorted(members, key=lambda member: member.name)), tuple(accepted))


def _of_path(path: str) -> Inventory:
    if why := refusal(path):
        raise ConfigError(why)
    if path.endswith(ARCHIVES):
        return Inventory((Member(archive_name(path), (path,)),))
    if os.path.isfile(path):
        if path.endswith(".toml"):
            return read_fleet_file(path)
        return read_ansible(path)
    if os.path.isfile(os.path.join(path, FILE_NAME)):
        return read_fleet_file(os.path.join(path, FILE_NAME))
    return Inventory((Member(os.path.basename(os.path.abspath(path)), (path,)),))


def archive_name(path: str) -> str:
    name = os.path.basename(path)
    return next(name[: -len(ending)] for ending in sorted(ARCHIVES, key=len, reverse=True) if name.endswith(ending))


def read_fleet_file(path: str) -> Inventory:
    """A ``fleet.toml``; its paths are relative to its folder. Raises ConfigError."""
    text = text_of(path)
    try:
        data = read_toml(text)
    except ValueError as error:
        line = line_of(error, text)
        raise ConfigError(f"{path}{f':{line}' if line else ''}: {error}") from error
    _checked(path, "", data)
    for name, site in data.get("site", {}).items():
        _checked(path, "site", site)
        if site.get("domains", TALKS[0]) not in TALKS:
            raise ConfigError(f"{path}: site '{name}': domains is one of {', '.join(TALKS)}")
    folder = Path(path).parent
    members = tuple(_member(path, folder, row, data.get("site", {})) for row in data.get("robot", ()))
    accepted = data.get("accept", ())
    lines = [number for number, line in enumerate(text.split("\n"), 1) if _ACCEPT.match(line)]
    if len(lines) != len(accepted):
        lines = [1] * len(accepted)
    return Inventory(members, tuple(_accepted(path, row, line) for row, line in zip(accepted, lines)))


def _member(path: str, folder: Path, row: dict[str, Any], sites: dict[str, dict[str, str]]) -> Member:
    _checked(path, "robot", row)
    if not row.get("name"):
        raise ConfigError(f"{path}: a robot has no name")
    layers = [row["root"]] if "root" in row else []
    layers += row.get("overlays", [])
    if not layers:
        raise ConfigError(f"{path}: robot '{row['name']}' has neither root nor overlays")
    places = tuple(os.path.normpath(folder / layer) for layer in layers)
    for place in places:
        if why := refusal(place):
            raise ConfigError(f"{path}: robot '{row['name']}': {why}")
    site = row.get("site", "")
    talks = sites.get(site, {}).get("domains", "")
    return Member(row["name"], places, row.get("role", ROLE), site, row.get("domain"), talks)


def _accepted(path: str, row: dict[str, Any], line: int) -> Accepted:
    _checked(path, "accept", row)
    if not row.get("rule") or not row.get("reason"):
        raise ConfigError(f"{path}: what is accepted needs a rule and a reason")
    return Accepted(
        row["rule"], tuple(row.get("robots", ())), row.get("key", ""), row["reason"], display_name(path), line
    )


def _checked(path: str, table: str, row: object) -> None:
    """Raises ConfigError for unknown keys and values of a wrong type."""
    known = _KEYS[table]
    where = f"{path}: {table}".rstrip(": ")
    if not isinstance(row, dict):
        raise ConfigError(f"{where}: not a table")
    for key, value in row.items():
        if key not in known:
            near = meant(key, known)
            raise ConfigError(f"{where}: unknown key '{key}'" + (f"; did you mean '{near}'?" if near else ""))
        if not isinstance(value, known[key]) or isinstance(value, bool):
            raise ConfigError(f"{where}: {key} is not of type {known[key].__name__}")
        if key in ("overlays", "robots") and not _are_texts(value):
            raise ConfigError(f"{where}: {key} holds something that is not a string")


def _are_texts(value: object) -> bool:
    return isinstance(value, list) and all(isinstance(each, str) for each in value)
