"""ROS 2 parameter files: YAML whose node blocks hold ``ros__parameters``."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_YAML = regex(r"\.ya?ml(?:\.(?:in|em|j2|jinja2?|tmpl|template))?$")
_ELSEWHERE = regex(
    r"/(?:\.github|\.gitlab|\.circleci|\.pre-commit)[^/]*(?:/|$)|/(?:docker-)?compose(?:[.-][^/]*)?\.ya?ml$|^/?mkdocs"
)
_HEADER = regex(
    r"^[ \t]*(?:[\"'])?ros_{1,3}param(?:eter)?s?(?:[\"'])?[ \t]*:(?:[ \t\r]|$)"
    r"|[{,][ \t]*[\"']?ros__parameters[\"']?[ \t]*:",
    re.M,
)


def _is_params(path: str, head: Head) -> bool:
    return bool(_YAML.search(path)) and not _ELSEWHERE.search(f"/{path}") and bool(_HEADER.search(head()))


KINDS = (Kind("params", _is_params),)
