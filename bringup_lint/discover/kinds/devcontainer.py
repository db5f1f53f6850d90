"""The description of a development container (containers.dev)."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind

_PATH = re.compile(r"(?:^|/)(?:\.devcontainer/(?:[^/]+/)?devcontainer|\.devcontainer)\.json$")


def _is_devcontainer(path: str, head: Head) -> bool:
    return bool(_PATH.search(path))


KINDS = (Kind("devcontainer", _is_devcontainer),)
