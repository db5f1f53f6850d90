"""sysusers.d files, which create users and groups."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_SOURCE = regex(r"(?:^|[/._-])sysusers(?:\.conf(?:\.in)?)?$")
"""How packages call the file that their build installs."""


def _is_sysusers(path: str, head: Head) -> bool:
    in_place = "/sysusers.d/" in f"/{path}" and path.endswith((".conf", ".conf.in"))
    return in_place or bool(_SOURCE.search(path))


KINDS = (Kind("sysusers", _is_sysusers, "sysusers"),)
