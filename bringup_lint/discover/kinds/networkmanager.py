"""Connection profiles of NetworkManager (keyfiles), and its own settings about Wi-Fi."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_FOLDER = regex(r"/NetworkManager/system-connections/[^/]+$")
_POWER_SAVE = regex(r"^[ \t]*wifi\.powersave[ \t]*=", re.M)
_WIFI_FILE = regex(r"(?:networkmanager|wi-?fi|wlan|power-?save)[^\n]{0,200}\.conf$", re.I)
_SECTION = regex(r"^\[connection\]", re.M)


def _is_profile(path: str, head: Head) -> bool:
    if path.endswith(".nmconnection"):
        return True
    return bool(_FOLDER.search(f"/{path}")) and bool(_SECTION.search(head()))


def _is_wifi_setting(path: str, head: Head) -> bool:
    return _WIFI_FILE.search(path) is not None and _POWER_SAVE.search(head()) is not None


KINDS = (
    Kind("networkmanager", _is_profile),
    Kind("networkmanager-wifi", _is_wifi_setting),
)
