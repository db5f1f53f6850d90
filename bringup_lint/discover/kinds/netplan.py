"""Netplan's YAML files, and the network configuration of cloud-init."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_FOLDER = regex(r"/(?:etc|run|lib)/netplan/[^/]+\.ya?ml$")
_YAML = regex(r"\.ya?ml$")
_CLOUD = regex(r"/(?:user-data|network-config|cloud\.cfg\.d/[^/]+\.cfg)(?:\.ya?ml)?$")
_TYPES = "ethernets|wifis|bonds|bridges|vlans|tunnels|vrfs|modems|dummy-devices|virtual-ethernets|nm-devices"
_NETPLAN = regex(
    r"^network:[ \t]*(?:#[^\n]*|\r)?\n(?:[ \t]*(?:#[^\n]*|\r)?\n)*"
    rf"[ \t]+(?:version:[ \t]*[\"']?2\b|renderer:|(?:{_TYPES}):)"
    rf"|^network:[ \t]*\{{[ \t\r\n]*(?:version[ \t]*:[ \t]*2\b|renderer[ \t]*:|(?:{_TYPES})[ \t]*:)",
    re.M,
)
_TOP_KEY = regex(r"^[\"']?([A-Za-z_][\w.-]*(?: +[\w.-]+)*) *(?:[\"'\t][ \t]*)?:(?:[ \t]|\r?$)", re.M)
"""Other keys beside ``network:`` mark a file of another tool that borrows netplan's format."""
_CLOUD_NETWORK = regex(r"^network:|^version:[ \t]*[12]\b", re.M)


def _is_cloud_init(path: str, head: Head) -> bool:
    if _CLOUD.search(f"/{path}"):
        return bool(_CLOUD_NETWORK.search(head()))
    return bool(_YAML.search(path)) and head().startswith("#cloud-config") and bool(_NETPLAN.search(head()))


def _is_netplan(path: str, head: Head) -> bool:
    if not _YAML.search(path) or _CLOUD.search(f"/{path}"):
        return False
    if _FOLDER.search(f"/{path}"):
        return True
    text = head()
    if not _NETPLAN.search(text) or text.startswith("#cloud-config"):
        return False
    return all(key == "network" for key in _TOP_KEY.findall(text))


KINDS = (
    Kind("cloud-init-network", _is_cloud_init),
    Kind("netplan", _is_netplan),
)
