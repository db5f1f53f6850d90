"""Network files of systemd-networkd and udev's link files."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_NAME = regex(r"\.(?:network|netdev|link)$|\.(?:network|netdev|link)\.d/[^/]+\.conf$")
_SECTION = regex(r"^\[(?:Match|Network|NetDev|Link|CAN|Address|Route)\]", re.M)


def _is_networkd(path: str, head: Head) -> bool:
    return bool(_NAME.search(path)) and ("/systemd/network/" in f"/{path}" or bool(_SECTION.search(head())))


KINDS = (Kind("networkd", _is_networkd),)
