"""Lists of packages: what pip and apt are to install."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_NAME = regex(r"/(?:[\w.-]*[_.-])?requirements?(?:[_.-][\w.-]*)?\.(?:txt|in)$|/requirements/[\w.-]+\.(?:txt|in)$", re.I)
_PROSE = regex(r"^[ \t]*[A-Za-z][\w.-]*[ \t]+[A-Za-z][\w.-]*[ \t]+[A-Za-z]", re.M)
"""A line of words, as no list has."""


def _is_pip(path: str, head: Head) -> bool:
    return bool(_NAME.search(f"/{path}")) and not _PROSE.search(head())


KINDS = (Kind("pip-requirements", _is_pip, "equirement"),)
