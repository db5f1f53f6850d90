"""Configuration of access points and Wi-Fi clients: hostapd.conf(5), wpa_supplicant.conf(5)."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_HOSTAPD = regex(r"(?:^|/)hostapd[^/]*\.conf$")
_ACCESS_POINT = regex(r"^[ \t]*(?:interface|ssid|wpa|wpa_passphrase)=", re.M)
_SUPPLICANT = regex(r"(?:^|/)wpa_supplicant[^/]*\.conf$")
_NETWORK = regex(r"^[ \t]*network=\{", re.M)


def _is_hostapd(path: str, head: Head) -> bool:
    return bool(_HOSTAPD.search(path)) and bool(_ACCESS_POINT.search(head()))


def _is_supplicant(path: str, head: Head) -> bool:
    return bool(_SUPPLICANT.search(path)) and bool(_NETWORK.search(head()))


KINDS = (
    Kind("hostapd", _is_hostapd),
    Kind("wpa-supplicant", _is_supplicant),
)
