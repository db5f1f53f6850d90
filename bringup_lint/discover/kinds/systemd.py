"""Unit files, drop-ins and what enables them."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import UNIT_TYPES
from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex
from bringup_lint.templates import SUFFIXES

_TYPES = "|".join(UNIT_TYPES)
_TEMPLATE = rf"(?:{'|'.join(map(re.escape, SUFFIXES))})?"
_UNIT = regex(rf"/[^/]+\.(?:{_TYPES}){_TEMPLATE}$")
_DROPIN = regex(rf"/(?:[^/]*\.)?(?:{_TYPES})\.d/[^/]+$", 0, ".d/")
_LINK = regex(r"\.(?:wants|requires|upholds)/[^/]+$", 0, ".wants/ .requires/ .upholds/")
_SECTION = regex(r"^\ufeff?[^\S\n]*\[(?:Unit|Service|Install|Socket|Timer|Path|Mount|Automount|Swap|Slice)\]", re.M)
_CONF = regex(rf"\.conf{_TEMPLATE}$", 0, ".conf")
_SERVICE = tuple(regex(rf"^[^\S\n]*{word}", re.M) for word in (r"\[Unit\]", r"\[Service\]", r"ExecStart\s*="))
"""What makes a service of a file with another name, in this order."""
_CODE = regex(
    r"^[ \t]*(?:function[ \t]+\w|[A-Za-z_][\w-]{0,80}[ \t]*\([ \t]*\)[ \t]*\{|if[ \t]+\[)|<<-?[ \t]*[\"']?[A-Z]", re.M
)
"""What only a script has, which may write a unit."""
_BACKUP = regex(r"(?:~|\.(?:bak|orig|rej|swp|dpkg-\w+|rpm\w+|ucf-\w+))$")


def _is_dropin(path: str, head: Head) -> bool:
    path = f"/{path}"
    return bool(_DROPIN.search(path)) and not _BACKUP.search(path) and not path.rpartition("/")[2].startswith("README")


def _is_unit(path: str, head: Head) -> bool:
    path = f"/{path}"
    if _CONF.search(path) and not _DROPIN.search(path):
        return _is_service(head()) and not _CODE.search(head())
    if not _UNIT.search(path) or "/dbus-1/" in path:
        return False
    if "/systemd/" in path or _LINK.search(path):
        return True
    return bool(_SECTION.search(head())) or not head().strip()


def _is_service(text: str) -> bool:
    at = 0
    for pattern in _SERVICE:
        found = pattern.search(text, at)
        if found is None:
            return False
        at = found.end()
    return True


KINDS = (
    Kind("systemd-dropin", _is_dropin),
    Kind("systemd-unit", _is_unit),
)
