"""Dockerfiles."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_NAME = regex(r"(?:^|/)(?:(?:Dockerfile|Containerfile)(?:[._-][\w.-]+)?|[\w.-]+\.(?:[Dd]ockerfile|[Cc]ontainerfile))$")
_OTHER_NAME = regex(r"(?:^|/)(?:\.?[Dd]ocker(?:files?|s)?/[\w-]+|[\w-]*Dockerfile[\w-]*)$")
"""Names without an ending, which say little."""
_NOT = regex(r"\.(?:dockerignore|md|rst|txt|py|sh|ya?ml|json|html|orig|bak)$|~$")
_FROM = regex(r"^[^\S\n]*FROM\s+\S", re.M | re.I)
_BEGIN = regex(r"(?:[ \t]*(?:#[^\n]*|ARG[ \t][^\n]*)?\n)*FROM[ \t]+\S")
"""How no other file begins."""


def _is_dockerfile(path: str, head: Head) -> bool:
    if _NAME.search(path):
        return not _NOT.search(path) and bool(_FROM.search(head()))
    return bool(_OTHER_NAME.search(path)) and bool(_BEGIN.match(head()))


KINDS = (Kind("dockerfile", _is_dockerfile),)
