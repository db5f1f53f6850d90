"""Dockerfiles."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_NAME = regex(r"(?:^|/)(?:(?:Dockerfile|Containerfile)(?:[._-][\w.-]+)?|[\w.-]+\.(?:[Dd]ockerfile|[Cc]ontainerfile))$")
_NOT = regex(r"\.(?:dockerignore|md|rst|txt|py|sh|ya?ml|json|html|orig|bak)$|~$")
_FROM = regex(r"^[^\S\n]*FROM\s+\S", re.M | re.I)


def _is_dockerfile(path: str, head: Head) -> bool:
    return bool(_NAME.search(path)) and not _NOT.search(path) and bool(_FROM.search(head()))


KINDS = (Kind("dockerfile", _is_dockerfile),)
