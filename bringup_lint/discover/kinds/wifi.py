"""Configuration of access points and Wi-Fi clients: hostapd.conf(5), wpa_supplicant.conf(5)."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind

_HOSTAPD = re.compile(r"(?:^|/)hostapd[^/]*\.conf$")
_ACCESS_POINT = re.compile(r"^[ \t]*(?:interface|ssid|wpa|wpa_passphrase)=", re.M)
_SUPPLICANT = re.compile(r"(?:^|/)wpa_supplicant[^/]*\.conf$")
_NETWORK = re.compile(r"^[ \t]*network=\{", re.M)


def _is_hostapd(path: str, head: Head) -> bool:
    return bool(_HOSTAPD.search(path)) and bool(_ACCESS_POINT.search(head()))


def _is_supplicant(path: str, head: Head) -> bool:
    return bool(_SUPPLICANT.search(path)) and bool(_NETWORK.search(head()))


KINDS = (
    Kind("hostapd", _is_hostapd),
    Kind("wpa-supplicant", _is_supplicant),
)
