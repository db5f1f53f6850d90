"""sysusers.d files, which create users and groups."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind


def _is_sysusers(path: str, head: Head) -> bool:
    return "/sysusers.d/" in f"/{path}" and path.endswith((".conf", ".conf.in"))


KINDS = (Kind("sysusers", _is_sysusers),)
