"""Files of variables: Ansible's inventories, groups, hosts and roles; code-server; drivers with YAML of their own."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_OF_HOSTS = regex(r"/(?:group|host)_vars/(?:[^/]+/)?[^/.]+(?:\.ya?ml)?$|/roles/[^/]+/(?:defaults|vars)/[^/]+\.ya?ml$")
_INVENTORY = regex(
    r"/[^/]*(?:hosts|inventory)[^/.]*(?:\.ini|\.ya?ml)?$|/(?:hosts|inventor(?:y|ies))/[^/]+\.(?:ini|ya?ml)$"
)
_OF_INVENTORY = regex(r"\bansible_(?:host|user|connection|port|python_interpreter|\w*pass(?:word)?)[ \t]*[=:]")
TASKS = regex(r"^[ \t]*-[ \t]+(?:name|hosts|become|ansible\.builtin\.\w+)[ \t]*:", re.M)
_OF_OTHERS = regex(r"\bros__parameters\b|^services:", re.M)
_CODE_SERVER = (regex(r"^bind-addr:", re.M), regex(r"^auth:", re.M))
"""Keys that only the configuration of code-server has both of."""
_OF_DRIVERS = regex(r"/(?:config|configs|cfg|params?)/")
_DEVICE = regex(r"^[ \t]*(?:- )?[\w.-]+[ \t]*:[ \t]*[\"']?/dev/(?:tty|video|serial|i2c|spi|input)", re.M)


def is_of_hosts(path: str) -> bool:
    """Whether Ansible reads the file as variables, by its place: lists with names in it are no tasks."""
    return bool(_OF_HOSTS.search(f"/{path}"))


def _is_variables(path: str, head: Head) -> bool:
    if is_of_hosts(path):
        return not _OF_OTHERS.search(head())
    if not _INVENTORY.search(f"/{path}") or not _OF_INVENTORY.search(head()):
        return False
    return not _OF_OTHERS.search(head()) and not TASKS.search(head())


def _has_both(text: str) -> bool:
    return all(pattern.search(text) for pattern in _CODE_SERVER)


def _is_code_server(path: str, head: Head) -> bool:
    return path.endswith((".yaml", ".yml")) and "config" in path and _has_both(head())


def _is_driver_config(path: str, head: Head) -> bool:
    """Whether a file that no parameter file is names a device."""
    if not path.endswith((".yaml", ".yml")) or not _OF_DRIVERS.search(f"/{path}"):
        return False
    return bool(_DEVICE.search(head())) and not _OF_OTHERS.search(head())


KINDS = (
    Kind("ansible-vars", _is_variables),
    Kind("code-server", _is_code_server),
    Kind("driver-config", _is_driver_config),
)
