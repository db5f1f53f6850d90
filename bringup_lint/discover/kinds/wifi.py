"""Configuration of access points, their clients and addresses: hostapd.conf(5), wpa_supplicant.conf(5), dnsmasq(8)."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_HOSTAPD = regex(r"(?:^|/)hostapd[^/]*\.conf$")
_ACCESS_POINT = regex(r"^[ \t]*(?:interface|ssid|wpa|wpa_passphrase)=", re.M)
_SUPPLICANT = regex(r"(?:^|/)wpa_supplicant[^/]*\.conf$")
_DNSMASQ = regex(r"(?:^|/)(?:dnsmasq[^/]*\.conf|dnsmasq\.d/[^/]+)$")
_RANGE = regex(r"^[ \t]*dhcp-range=", re.M)
_NETWORK = regex(r"^[ \t]*network=\{", re.M)


def _is_hostapd(path: str, head: Head) -> bool:
    return bool(_HOSTAPD.search(path)) and bool(_ACCESS_POINT.search(head()))


def _is_supplicant(path: str, head: Head) -> bool:
    return bool(_SUPPLICANT.search(path)) and bool(_NETWORK.search(head()))


def _is_dnsmasq(path: str, head: Head) -> bool:
    return bool(_DNSMASQ.search(path)) and bool(_RANGE.search(head()))


KINDS = (
    Kind("hostapd", _is_hostapd),
    Kind("wpa-supplicant", _is_supplicant),
    Kind("dnsmasq", _is_dnsmasq),
)
