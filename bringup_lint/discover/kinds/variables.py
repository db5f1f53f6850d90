"""Files of variables with which a machine is set up: Ansible's inventories, groups, hosts and roles; code-server."""

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
_OF_OTHERS = regex(
    r"^[ \t]*-[ \t]+(?:name|hosts|become|ansible\.builtin\.\w+)[ \t]*:|\bros__parameters\b|^services:", re.M
)
_CODE_SERVER = (regex(r"^bind-addr:", re.M), regex(r"^auth:", re.M))
"""Keys that only the configuration of code-server has both of."""


def _is_variables(path: str, head: Head) -> bool:
    path = f"/{path}"
    if _OF_HOSTS.search(path):
        return not _OF_OTHERS.search(head())
    return bool(_INVENTORY.search(path)) and bool(_OF_INVENTORY.search(head())) and not _OF_OTHERS.search(head())


def _has_both(text: str) -> bool:
    return all(pattern.search(text) for pattern in _CODE_SERVER)


def _is_code_server(path: str, head: Head) -> bool:
    return path.endswith((".yaml", ".yml")) and "config" in path and _has_both(head())


KINDS = (
    Kind("ansible-vars", _is_variables),
    Kind("code-server", _is_code_server),
)
