"""The description of a development container (containers.dev)."""

from __future__ import annotations

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_PATH = regex(r"(?:^|/)(?:\.devcontainer/(?:[^/]+/)?devcontainer|\.devcontainer)\.json$")


def _is_devcontainer(path: str, head: Head) -> bool:
    return bool(_PATH.search(path))


KINDS = (Kind("devcontainer", _is_devcontainer, "devcontainer"),)
