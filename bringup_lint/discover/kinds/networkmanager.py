"""Connection profiles of NetworkManager (keyfiles)."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_FOLDER = regex(r"/NetworkManager/system-connections/[^/]+$")
_SECTION = regex(r"^\[connection\]", re.M)


def _is_profile(path: str, head: Head) -> bool:
    if path.endswith(".nmconnection"):
        return True
    return bool(_FOLDER.search(f"/{path}")) and bool(_SECTION.search(head()))


KINDS = (Kind("networkmanager", _is_profile),)
