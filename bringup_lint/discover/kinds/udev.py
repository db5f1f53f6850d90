"""udev rules files, and files that lie beside them under a name that udev does not read."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex
from bringup_lint.templates import final_name

_OTHERS = regex(r"/(?:polkit-1|polkit|audit|auditd|suricata|snort|prometheus)/|/audit[^/]*/rules\.d/")
_TOKEN = (
    r"(?:ACTION|SUBSYSTEMS?|KERNELS?|DRIVERS?|DEVPATH|TAGS?|PROGRAM"
    r"|(?:ATTRS?|ENV|IMPORT)\{[^}\n]+\})"
    r"[ \t]*(?:==|!=|\+=|:=|=)[ \t]*[ei]{0,2}[\"']"
)
_KEY = regex(rf"^\ufeff?[ \t]*{_TOKEN}", re.M | re.I)
_ANY_KEY = regex(rf"\b{_TOKEN}")
_NUMBERED = regex(r"/\d\d-[^/]+\.rules\Z")
"""A name such as ``99-robot.rules``, which udev shares with polkit and auditd: the keys tell them apart."""
_DEBIAN = regex(r"/debian/(?:[\w.+-]+\.)?udev$")
"""The rules of a package, to which dh_installudev gives a name (``60-PACKAGE.rules``)."""


def _is_rules(path: str, head: Head) -> bool:
    path = f"/{path}"
    if _DEBIAN.search(path):
        return bool(_KEY.search(head()))
    if not final_name(path).endswith(".rules") or _OTHERS.search(path):
        return False
    if "/udev/rules.d/" in path:
        return True
    numbered = _NUMBERED.search(final_name(path))
    return bool((_ANY_KEY if numbered else _KEY).search(head()))


def _is_misnamed(path: str, head: Head) -> bool:
    """A file in a udev rules folder that only its name keeps from being read."""
    path = f"/{path}"
    if "/udev/rules.d/" not in path or final_name(path).endswith(".rules"):
        return False
    return not path.rpartition("/")[2].startswith((".", "README")) and bool(_KEY.search(head()))


KINDS = (
    Kind("udev-rules", _is_rules),
    Kind("udev-misnamed", _is_misnamed),
)
