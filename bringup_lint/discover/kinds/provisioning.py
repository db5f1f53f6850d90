"""What sets a machine up: Ansible's tasks and playbooks, cloud-init's user data."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.discover.kinds.variables import TASKS
from bringup_lint.discover.kinds.variables import is_of_hosts
from bringup_lint.pattern import regex

_YAML = regex(r"\.ya?ml$")
_FOLDER = regex(r"/(?:tasks|handlers|playbooks|ansible|roles)/")
_PLAY = regex(r"^(?:-[ \t]+|[ \t]{2,6})hosts[ \t]*:[^\n]", re.M)
_PLAYS = regex(r"^[ \t]{2,6}(?:roles|(?:pre_|post_)?tasks)[ \t]*:", re.M)
_USER_DATA = regex(r"#cloud-config\b")
_NETWORK = regex(r"^network:", re.M)
"""User data with a network configuration is read as that."""


def _is_ansible(path: str, head: Head) -> bool:
    path = f"/{path}"
    if not _YAML.search(path) or is_of_hosts(path):
        return False
    if _FOLDER.search(path):
        return bool(TASKS.search(head()))
    return bool(_PLAY.search(head()) and _PLAYS.search(head()))


def _is_cloud_init(path: str, head: Head) -> bool:
    name = path.rpartition("/")[2]
    named = bool(_YAML.search(name)) or "user-data" in name or "cloud" in name
    return named and bool(_USER_DATA.match(head())) and not _NETWORK.search(head())


KINDS = (
    Kind("ansible", _is_ansible),
    Kind("cloud-init", _is_cloud_init),
)
