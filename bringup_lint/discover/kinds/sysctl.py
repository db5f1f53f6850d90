"""Kernel parameters: sysctl.d(5) and /etc/sysctl.conf."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_SYSCTL = regex(r"/sysctl\.d/[^/]+\.conf$|/etc/sysctl\.conf$")


def _is_sysctl(path: str, head: Head) -> bool:
    return bool(_SYSCTL.search(f"/{path}"))


KINDS = (Kind("sysctl", _is_sysctl),)
