"""Kernel parameters: sysctl.d(5) and /etc/sysctl.conf."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind

_SYSCTL = re.compile(r"/sysctl\.d/[^/]+\.conf$|/etc/sysctl\.conf$")


def _is_sysctl(path: str, head: Head) -> bool:
    return bool(_SYSCTL.search(f"/{path}"))


KINDS = (Kind("sysctl", _is_sysctl),)
