"""Configuration of supervisord: the main file, and the files that Debian's package includes."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_MAIN = regex(r"(?:^|/)supervisord?\.(?:conf|ini)$")
_INCLUDED = regex(r"(?:^|/)supervisord?(?:/conf\.d)?/[^/]+\.(?:conf|ini)$")
_SECTION = regex(r"^\[(?:program|supervisord|group|eventlistener|fcgi-program|unix_http_server)\b", re.M)


def _is_supervisord(path: str, head: Head) -> bool:
    return bool(_MAIN.search(path)) or (bool(_INCLUDED.search(path)) and bool(_SECTION.search(head())))


KINDS = (Kind("supervisord", _is_supervisord),)
