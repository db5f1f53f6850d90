"""Compose files."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex
from bringup_lint.templates import final_name
from bringup_lint.templates import is_sample

_YAML = regex(r"\.ya?ml$")
_NAMED = regex(r"(?:^|[/._-])compose(?:[._-][^/]*)?\.ya?ml$", re.I)
_DEFAULT = regex(r"(?:^|/)(?:docker-)?compose\.ya?ml$")
"""The names that docker compose looks for itself."""
_LIKE = regex(r"^(?:services?|version|include|networks|volumes)[ \t]*:", re.M)
_SERVICES = regex(r"^services:[ \t]*(?:[#{].*)?\r?$", re.M)
_RUNS = regex(r"^[ \t]+(?:image|build):", re.M)


def _is_compose(path: str, head: Head) -> bool:
    if is_sample(path):
        path = final_name(path)
    if not _YAML.search(path):
        return False
    if not _NAMED.search(path) and ".github/" in path:
        return False
    if _DEFAULT.search(path) and _LIKE.search(head()):
        return True
    return bool(_SERVICES.search(head())) and (bool(_NAMED.search(path)) or bool(_RUNS.search(head())))


KINDS = (Kind("compose", _is_compose),)
