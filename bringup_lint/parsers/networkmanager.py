"""Keyfiles of NetworkManager: GLib's grammar of groups and keys, nm-settings-keyfile(5)."""

from __future__ import annotations

import re
from functools import cache

from bringup_lint.addresses import is_address
from bringup_lint.addresses import is_prefix_length
from bringup_lint.model.networkmanager import ALIASES
from bringup_lint.model.networkmanager import FALSE
from bringup_lint.model.networkmanager import TRUE
from bringup_lint.model.networkmanager import Profile
from bringup_lint.model.networkmanager import Setting
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Fault
from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.pattern import regex
from bringup_lint.schema.table import Schema
from bringup_lint.schema.table import listed
from bringup_lint.schema.table import load
from bringup_lint.schema.walk import level
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

_GROUP = regex(r"\[([^\[\]]+)\][ \t]*")
_NUMBERED = regex(r"(address|addresses|route|routes|routing-rule)\d+(?:_options)?")
_INTEGER = regex(r"[+-]?(?:0[xX][0-9a-fA-F]+|[0-9]+)")


@cache
def schema() -> Schema:
    return load("network/networkmanager")


def parse(source: Source) -> Profile:
    """Read a profile. Problems: ``syntax`` where GLib refuses the whole file, and those of ``Code``."""
    profile = Profile(source)
    section: Located | None = None
    for number, start in enumerate(source.line_starts, 1):
        line = source.located(start, start + len(source.line_text(number)))
        if not line.strip() or line.startswith("#"):
            continue
        group = _GROUP.fullmatch(line)
        if group is not None:
            section = line.part(*group.span(1))
        elif section is None or not line.partition("=")[0].strip() or "=" not in line:
            profile.problems.append(Problem("syntax", line))
        else:
            key, _, _ = line.partition("=")
            value = line.part(len(key) + 1, len(line)).strip_located()
            _setting(profile, section, line.part(0, len(key)).strip_located(), value)
    return profile


def _setting(profile: Profile, section: Located, key: Located, value: Located) -> None:
    profile.settings.append(Setting(ALIASES.get(section, str(section)), key, value))
    item = _section_of(section)
    if item is None:
        return
    numbered = _NUMBERED.fullmatch(key)
    found = level([(key.part(0, len(numbered[1])) if numbered else key, value)], item.children, item)
    profile.problems.extend(found.remarks)
    for _, known in found.known:
        fault = fault_of(known, value)
        if fault is not None:
            profile.problems.append(Remark(fault.code, value, fault.detail, fault.fatal, known))


def _section_of(name: str) -> Item | None:
    return schema().top.children.get(ALIASES.get(name, name))


def fault_of(item: Item, text: str) -> Fault | None:
    """What NetworkManager has against a value. It drops most of them and goes on with the default; an unknown word
    makes it refuse the profile."""
    if item.type == "bool":
        return None if text in TRUE + FALSE else Fault(Code.BOOL, "true or false", False)
    if item.type == "int":
        fits = text in item.words or _INTEGER.fullmatch(text)
        return None if fits else Fault(Code.NUMBER, listed(("a number", *item.words)), False)
    if item.type == "enum":
        return None if text in item.words else Fault(Code.ENUM, listed(item.words))
    if item.type.startswith("address") and not _addresses(text, item):
        several = item.type.startswith("addresses")
        return Fault(Code.ADDRESS, "addresses separated by semicolons" if several else "ADDRESS/PREFIX", False)
    return None


def _addresses(text: str, item: Item) -> bool:
    version = int(item.type[-1])
    if item.type.startswith("addresses"):
        return all(is_address(each.strip(), version) for each in text.split(";") if each)
    host, slash, prefix = re.split(r"[,; ]", text.strip(), maxsplit=1)[0].partition("/")
    return is_address(host.strip(), version) and (not slash or is_prefix_length(prefix, version))
